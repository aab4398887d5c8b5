// SPDX-License-Identifier: BSD-3-Clause
#include "places_panel.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QVBoxLayout>

#include <geometry_msgs/PoseStamped.h>
#include <pluginlib/class_list_macros.hpp>
#include <rviz/properties/property.h>
#include <rviz/tool_manager.h>
#include <rviz/visualization_manager.h>

#include "plan_requests.h"

namespace agrid_map_rviz {

using agrid_map::Tag;

PlacesPanel::PlacesPanel(QWidget* parent)
    : rviz::Panel(parent),
      node_(new QLineEdit("agrid")),
      goal_topic_(new QLineEdit("move_base_simple/goal")),
      search_(new QLineEdit),
      list_(new PlaceList),
      start_(new QComboBox),
      routes_(new QListWidget),
      answer_(new QLabel) {
  makeButtons();
  lay();
  connect(node_, &QLineEdit::editingFinished, this, &PlacesPanel::useNode);
  connect(goal_topic_, &QLineEdit::editingFinished, this, &PlacesPanel::useGoalTopic);
  connect(search_, &QLineEdit::textChanged, list_, &PlaceList::search);
  connect(routes_, &QListWidget::currentRowChanged, this, [this](int row) {
    session_->chooseRoute(row < 0 ? agrid_map::Route() : ways_[static_cast<std::size_t>(row)]);
  });
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &PlacesPanel::updateButtons);
  connect(list_, &PlaceList::renamed, this, [this](const Place& place, const QString& name) {
    const QString before = called(place);
    if (name.isEmpty() || name == before) return showGraph();
    session_->apply(tr("%1 is called %2 now").arg(before, name),
                    {rename(place, name.toStdString())});
  });
  connect(list_, &PlaceList::categoryGiven, this, [this](const Place& place, const QString& text) {
    if (text.isEmpty()) return showAnswer(false, tr("a category can be changed, not emptied"));
    session_->apply(tr("%1 is a %2 now").arg(called(place), text),
                    {setCategory(place, text.toStdString())});
  });
}

QPushButton* PlacesPanel::addButton(const QString& text, const QString& name, const QString& hint) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(hint);
  return button;
}

void PlacesPanel::makeButtons() {
  rename_ = addButton(tr("Rename"), "rename", tr("Types another name (or double-click it)"));
  category_ = addButton(tr("Category"), "category", tr("Types a category: kitchen, fridge ..."));
  open_ = addButton(tr("Open"), "open", tr("The selected doors are open"));
  close_ = addButton(tr("Close"), "close", tr("The selected doors are closed: plans go around"));
  split_ = addButton(tr("Split"), "split", tr("Drag a line across an area: a door parts it there"));
  join_ = addButton(tr("Join"), "join", tr("Two areas become one: the doors between them go"));
  remove_ = addButton(tr("Delete"), "delete", tr("Takes back what was said of it"));
  go_ = addButton(tr("Go to"), "go", tr("Sends the robot there"));
  plan_ = addButton(tr("Plan to"), "plan", tr("Shows the path there"));
  alternatives_ = addButton(tr("Routes"), "routes", tr("Shows the ways there, best first"));
  undo_ = addButton(tr("Undo"), "undo", tr("Takes the last change back, of the tool as well"));
  connect(rename_, &QPushButton::clicked, list_, [this] { list_->editSelected(PlaceList::kName); });
  connect(category_, &QPushButton::clicked, list_,
          [this] { list_->editSelected(PlaceList::kCategory); });
  connect(open_, &QPushButton::clicked, this, [this] { setDoorState(agrid_map::Door::OPEN); });
  connect(close_, &QPushButton::clicked, this, [this] { setDoorState(agrid_map::Door::CLOSED); });
  connect(split_, &QPushButton::clicked, this, &PlacesPanel::split);
  connect(join_, &QPushButton::clicked, this, &PlacesPanel::join);
  connect(remove_, &QPushButton::clicked, this, &PlacesPanel::removeSelected);
  connect(go_, &QPushButton::clicked, this, [this] { plan(Wish::kGo); });
  connect(plan_, &QPushButton::clicked, this, [this] { plan(Wish::kPlan); });
  connect(alternatives_, &QPushButton::clicked, this, &PlacesPanel::planRoutes);
  connect(undo_, &QPushButton::clicked, this, [this] { session_->undo(); });
}

void PlacesPanel::lay() {
  search_->setObjectName("search");
  search_->setPlaceholderText(tr("search"));
  search_->setClearButtonEnabled(true);
  start_->setObjectName("start");
  node_->setObjectName("node");
  goal_topic_->setObjectName("goal_topic");
  answer_->setObjectName("answer");
  answer_->setWordWrap(true);
  answer_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  routes_->setObjectName("route_list");
  routes_->setMaximumHeight(90);
  routes_->hide();
  auto* buttons = new QGridLayout;
  int place = 0;
  for (QPushButton* button : {rename_, category_, open_, close_, split_, join_, remove_, undo_, go_,
                              plan_, alternatives_}) {
    buttons->addWidget(button, place / 4, place % 4);
    ++place;
  }
  auto* settings = new QFormLayout;
  settings->addRow(tr("From"), start_);
  settings->addRow(tr("Node"), node_);
  settings->addRow(tr("Goal topic"), goal_topic_);
  auto* column = new QVBoxLayout(this);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  column->addLayout(buttons);
  column->addWidget(routes_);
  column->addWidget(answer_);
  column->addLayout(settings);
}

void PlacesPanel::onInitialize() {
  useNode();
  useGoalTopic();
}

void PlacesPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString text;
  if (config.mapGetString("Node", &text)) node_->setText(text);
  if (config.mapGetString("Goal Topic", &text)) goal_topic_->setText(text);
  useNode();
  useGoalTopic();
}

void PlacesPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Node", node_->text());
  config.mapSetValue("Goal Topic", goal_topic_->text());
}

void PlacesPanel::useNode() {
  const QString node = node_->text().trimmed();
  if (session_ && session_->node() == node) return;
  std::string error;
  if (node.isEmpty() || !ros::names::validate(node.toStdString(), error)) {
    return showAnswer(false, tr("'%1' is no name of a node").arg(node));
  }
  if (session_) session_->disconnect(this);
  session_ = &EditSession::of(*vis_manager_, node);
  connect(session_, &EditSession::graphChanged, this, &PlacesPanel::showGraph);
  connect(session_, &EditSession::answered, this, &PlacesPanel::showAnswer);
  connect(session_, &EditSession::pathPlanned, this, &PlacesPanel::showPath);
  connect(session_, &EditSession::routesPlanned, this, &PlacesPanel::showRoutes);
  connect(session_, &EditSession::undoChanged, this, &PlacesPanel::updateButtons);
  showGraph();
  Q_EMIT configChanged();
}

void PlacesPanel::useGoalTopic() {
  const std::string topic = goal_topic_->text().trimmed().toStdString();
  std::string error;
  if (topic.empty() || !ros::names::validate(topic, error)) {
    return showAnswer(false, tr("'%1' is no name of a topic").arg(goal_topic_->text()));
  }
  if (goal_publisher_ && goal_publisher_.getTopic() == ros::names::resolve(topic)) return;
  goal_publisher_ = ros::NodeHandle().advertise<geometry_msgs::PoseStamped>(topic, 1);
  Q_EMIT configChanged();
}

void PlacesPanel::updateButtons() {
  int areas = 0, doors = 0;
  const std::vector<Place> places = list_->selectedPlaces();
  for (const Place& place : places) {
    areas += place.type == Tag::AREA;
    doors += place.type == Tag::DOOR;
  }
  const bool one = places.size() == 1;
  const bool only_doors = doors > 0 && doors == static_cast<int>(places.size());
  rename_->setEnabled(one);
  category_->setEnabled(one && doors == 0);
  open_->setEnabled(only_doors);
  close_->setEnabled(only_doors);
  join_->setEnabled(places.size() == 2 && areas == 2);
  remove_->setEnabled(!places.empty());
  for (QPushButton* button : {go_, plan_, alternatives_}) button->setEnabled(one && doors == 0);
  undo_->setEnabled(session_ && session_->canUndo());
}

void PlacesPanel::showGraph() {
  const agrid_map::TopologicalGraph& graph = session_->graph();
  list_->show(graph);
  const QString chosen = start_->currentText();
  start_->clear();
  start_->addItem(tr("the robot"), 0);
  for (const agrid_map::Area& area : graph.areas) {
    start_->addItem(QString::fromStdString(area.name), area.id);
  }
  start_->setCurrentIndex(std::max(0, start_->findText(chosen)));
  updateButtons();
}

void PlacesPanel::showAnswer(bool success, const QString& sentence) {
  answer_->setText(sentence);
  answer_->setStyleSheet(success ? "" : "color: #b00020");
  // a name that was refused is not shown as if it were one
  if (!success && session_) list_->show(session_->graph());
  updateButtons();
}

QString PlacesPanel::called(const Place& place) const { return nameOf(session_->graph(), place); }

void PlacesPanel::setDoorState(std::uint8_t state) {
  std::vector<Change> changes;
  QStringList names;
  for (const Place& place : list_->selectedPlaces()) {
    changes.push_back(agrid_map_rviz::setDoorState(place.id, state));
    names << called(place);
  }
  const QString sentence = state == agrid_map::Door::OPEN ? tr("open: %1") : tr("closed: %1");
  session_->apply(sentence.arg(names.join(", ")), changes);
}

void PlacesPanel::split() {
  rviz::ToolManager& tools = *vis_manager_->getToolManager();
  rviz::Tool* tool = nullptr;
  for (int i = 0; i < tools.numTools(); ++i) {
    if (tools.getTool(i)->getClassId() == "agrid_map/TagTool") tool = tools.getTool(i);
  }
  if (!tool) tool = tools.addTool("agrid_map/TagTool");
  tool->getPropertyContainer()->subProp("Node")->setValue(session_->node());
  tool->getPropertyContainer()->subProp("Action")->setValue("split");
  tools.setCurrentTool(tool);
  showAnswer(true, tr("drag a line across the area, from wall to wall"));
}

void PlacesPanel::join() {
  const std::vector<Place> places = list_->selectedPlaces();
  const auto changes = joining(session_->graph(), places[0].id, places[1].id);
  const QString names = called(places[0]) + ", " + called(places[1]);
  if (changes.empty()) return showAnswer(false, tr("no door joins %1").arg(names));
  session_->apply(tr("joined: %1").arg(names), changes);
}

void PlacesPanel::removeSelected() {
  std::vector<Change> changes;
  QStringList names;
  for (const Place& place : list_->selectedPlaces()) {
    changes.push_back(removal(place));
    names << called(place);
  }
  session_->apply(tr("deleted: %1").arg(names.join(", ")), changes);
}

void PlacesPanel::plan(Wish wish) {
  wish_ = wish;
  const auto places = list_->selectedPlaces();
  session_->planPath(
      pathRequest(session_->graph(), start_->currentData().toUInt(), places.front()));
  showAnswer(true, tr("planning ..."));
}

void PlacesPanel::planRoutes() {
  const auto places = list_->selectedPlaces();
  session_->planAreas(
      routesRequest(session_->graph(), start_->currentData().toUInt(), places.front()));
  showAnswer(true, tr("planning ..."));
}

void PlacesPanel::showPath(const agrid_map::PlanPath::Response& response) {
  const bool success = response.status.code == agrid_map::Status::SUCCESS;
  showAnswer(success,
             success ? describe(response) : QString::fromStdString(response.status.message));
  if (!success || wish_ != Wish::kGo || response.path.poses.empty()) return;
  geometry_msgs::PoseStamped goal = response.path.poses.back();
  goal.header = response.path.header;
  goal_publisher_.publish(goal);
}

void PlacesPanel::showRoutes(const agrid_map::PlanAreas::Response& response) {
  ways_ = response.routes;
  routes_->clear();
  const bool success = response.status.code == agrid_map::Status::SUCCESS;
  for (const agrid_map::Route& route : response.routes) routes_->addItem(describe(route));
  routes_->setVisible(success);
  routes_->setCurrentRow(0);
  const QString count = ways_.size() == 1 ? tr("one way") : tr("%1 ways").arg(ways_.size());
  showAnswer(success, success ? count : QString::fromStdString(response.status.message));
}

}  // namespace agrid_map_rviz

PLUGINLIB_EXPORT_CLASS(agrid_map_rviz::PlacesPanel, rviz::Panel)

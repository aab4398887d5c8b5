// SPDX-License-Identifier: BSD-3-Clause
#include "semantic_map_display.h"

#include <utility>

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <pluginlib/class_list_macros.hpp>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/string_property.h>

#include "graph_shapes.h"

namespace agrid_map_rviz {
namespace {

/// The texels of areas [m], as long as the picture stays in what every graphics card takes.
constexpr double kTexel = 0.025;
constexpr std::uint32_t kMaxSide = 4096;
/// How far a name stands above what it names [m].
constexpr double kNameOffset = 0.25;

std::vector<NameLayer::Name> namesOf(const agrid_map::TopologicalGraph& graph, float size) {
  std::vector<NameLayer::Name> names;
  for (const agrid_map::Area& area : graph.areas) {
    names.push_back({area.name, area.anchor.x, area.anchor.y + kNameOffset, size, {0, 0, 0, 1}});
  }
  for (const agrid_map::Object& object : graph.objects) {
    const auto& at = object.pose.position;
    names.push_back({object.name, at.x, at.y + kNameOffset, 0.7F * size, {0.7F, 0, 0, 1}});
  }
  return names;
}

}  // namespace

SemanticMapDisplay::SemanticMapDisplay() {
  node_ =
      new rviz::StringProperty("Node", "agrid", "The nodelet's name, as the prefix of its topics.",
                               this, SLOT(resubscribe()));
  alpha_ = new rviz::FloatProperty("Alpha", 0.45F, "How opaque the areas are.", this,
                                   SLOT(updateAlpha()));
  alpha_->setMin(0);
  alpha_->setMax(1);
  name_size_ = new rviz::FloatProperty("Name Size", 0.4F, "Height of the names [m].", this,
                                       SLOT(updateNames()));
  name_size_->setMin(0.05F);
  const auto part = [this](const char* name, bool shown, const char* what) {
    return new rviz::BoolProperty(name, shown, what, this, SLOT(updateVisibility()));
  };
  areas_on_ = part("Areas", true, "Areas, each in a colour that goes with its id.");
  names_on_ = part("Names", true, "Names of areas and objects.");
  doors_on_ = part("Doors", true,
                   "Red: closed; green: open; blue: not known; pale: a passage; "
                   "the less sure, the more transparent.");
  objects_on_ = part("Objects", true, "Objects as their boxes.");
  pending_on_ = part("Waiting", true, "Tags that wait for a sure place, orange.");
  graph_on_ = part("Graph", true, "Areas as nodes, joined through their doors.");
  route_on_ = part("Route", true, "The way that is chosen in the panel.");
  plan_on_ = part("Plan", true, "The last path.");
  cells_on_ = part("Cells", false, "The lines of the A-Grid.");
}

SemanticMapDisplay::~SemanticMapDisplay() {
  // the threaded queue may be painting
  unsubscribe();
}

void SemanticMapDisplay::onInitialize() {
  for (Framed* framed : {&grid_frame_, &graph_frame_, &plan_frame_}) {
    framed->node = scene_node_->createChildSceneNode();
    framed->pose.orientation.w = 1;
  }
  areas_ = std::make_unique<AreaLayer>(Stack{grid_frame_.node, 1});
  cells_ = std::make_unique<ShapeLayer>(Stack{grid_frame_.node, 2});
  edges_ = std::make_unique<ShapeLayer>(Stack{graph_frame_.node, 3});
  doors_ = std::make_unique<ShapeLayer>(Stack{graph_frame_.node, 4});
  objects_ = std::make_unique<ShapeLayer>(Stack{graph_frame_.node, 5});
  pending_ = std::make_unique<ShapeLayer>(Stack{graph_frame_.node, 6});
  route_ = std::make_unique<ShapeLayer>(Stack{graph_frame_.node, 7});
  plan_ = std::make_unique<ShapeLayer>(Stack{plan_frame_.node, 8});
  names_ = std::make_unique<NameLayer>(Stack{graph_frame_.node, 50});
  updateAlpha();
  updateVisibility();
}

void SemanticMapDisplay::onEnable() { subscribe(); }

void SemanticMapDisplay::onDisable() {
  unsubscribe();
  reset();
}

void SemanticMapDisplay::resubscribe() {
  unsubscribe();
  reset();
  if (isEnabled()) subscribe();
}

void SemanticMapDisplay::subscribe() {
  const std::string node = node_->getStdString();
  std::string error;
  if (node.empty() || !ros::names::validate(node, error)) {
    setStatusStd(rviz::StatusProperty::Error, "Graph", "'" + node + "' is no name of a node");
    return;
  }
  setStatusStd(rviz::StatusProperty::Warn, "Graph", "nothing came on " + node + "/graph yet");
  setStatusStd(rviz::StatusProperty::Warn, "Areas", "nothing came on " + node + "/agrid yet");
  // cells are many: they are painted in the other thread
  grid_subscriber_ = threaded_nh_.subscribe(node + "/agrid", 1, &SemanticMapDisplay::paint, this);
  graph_subscriber_ =
      update_nh_.subscribe(node + "/graph", 1, &SemanticMapDisplay::showGraph, this);
  session_ = &EditSession::of(*context_, node_->getString());
  connect(session_, &EditSession::routeChosen, this, &SemanticMapDisplay::showRoute);
  plan_subscriber_ = update_nh_.subscribe(node + "/plan", 1, &SemanticMapDisplay::showPlan, this);
}

void SemanticMapDisplay::unsubscribe() {
  for (ros::Subscriber* s : {&grid_subscriber_, &graph_subscriber_, &plan_subscriber_}) {
    s->shutdown();
  }
  if (session_) session_->disconnect(this);
}

void SemanticMapDisplay::reset() {
  rviz::Display::reset();
  if (!areas_) return;
  graph_.reset();
  chosen_ = {};
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    painted_.reset();
  }
  areas_->show({});
  for (const auto* layer : {&cells_, &edges_, &doors_, &objects_, &pending_, &route_, &plan_}) {
    (*layer)->show({});
  }
  names_->show({});
}

void SemanticMapDisplay::paint(const agrid_map::AGrid::ConstPtr& grid) {
  auto picture = std::make_unique<Picture>();
  picture->header = grid->header;
  picture->origin = grid->origin;
  picture->areas = paintAreas(*grid, kTexel, kMaxSide);
  picture->cells = cellShapes(*grid);
  picture->cell_count = grid->labels.size();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    painted_ = std::move(picture);
  }
  context_->queueRender();
}

void SemanticMapDisplay::showPicture() {
  std::unique_ptr<Picture> picture;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    picture.swap(painted_);
  }
  if (!picture) return;
  grid_frame_.header = picture->header;
  grid_frame_.pose = picture->origin;
  areas_->show(picture->areas);
  cells_->show(picture->cells);
  if (picture->areas.width == 0) {
    setStatus(rviz::StatusProperty::Error, "Areas", "the A-Grid's lengths do not fit each other");
  } else {
    setStatus(rviz::StatusProperty::Ok, "Areas", tr("%1 cells").arg(picture->cell_count));
  }
}

void SemanticMapDisplay::showGraph(const agrid_map::TopologicalGraph::ConstPtr& graph) {
  graph_ = graph;
  graph_frame_.header = graph->header;
  edges_->show(edgeShapes(*graph));
  doors_->show(doorShapes(*graph));
  objects_->show(objectShapes(*graph));
  pending_->show(pendingShapes(*graph));
  route_->show(routeShapes(*graph, chosen_));
  updateNames();
  setStatus(rviz::StatusProperty::Ok, "Graph",
            tr("%1 areas, %2 doors, %3 objects, %4 waiting")
                .arg(graph->areas.size())
                .arg(graph->doors.size())
                .arg(graph->objects.size())
                .arg(graph->pending.size()));
  updateVisibility();
}

void SemanticMapDisplay::showRoute(const agrid_map::Route& route) {
  chosen_ = route;
  if (graph_) route_->show(routeShapes(*graph_, chosen_));
  context_->queueRender();
}

void SemanticMapDisplay::showPlan(const nav_msgs::Path::ConstPtr& plan) {
  plan_frame_.header = plan->header;
  plan_->show(planShapes(*plan));
  context_->queueRender();
}

void SemanticMapDisplay::updateNames() {
  if (graph_) names_->show(namesOf(*graph_, name_size_->getFloat()));
  updateVisibility();
}

void SemanticMapDisplay::updateAlpha() {
  areas_->setAlpha(alpha_->getFloat());
  context_->queueRender();
}

void SemanticMapDisplay::updateVisibility() {
  areas_->setVisible(areas_on_->getBool());
  names_->setVisible(names_on_->getBool());
  doors_->setVisible(doors_on_->getBool());
  objects_->setVisible(objects_on_->getBool());
  pending_->setVisible(pending_on_->getBool());
  edges_->setVisible(graph_on_->getBool());
  route_->setVisible(route_on_->getBool());
  plan_->setVisible(plan_on_->getBool());
  cells_->setVisible(cells_on_->getBool());
  context_->queueRender();
}

void SemanticMapDisplay::place(const Framed& framed, const QString& name) {
  if (framed.header.frame_id.empty()) return;
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  // the newest transform: the map is latched, its stamp grows old
  const bool known = context_->getFrameManager()->transform(framed.header.frame_id, ros::Time(),
                                                            framed.pose, position, orientation);
  framed.node->setVisible(true, false);
  if (known) {
    framed.node->setPosition(position);
    framed.node->setOrientation(orientation);
    deleteStatus(name);
  } else {
    setStatus(rviz::StatusProperty::Error, name,
              tr("no transform from %1 to %2")
                  .arg(QString::fromStdString(framed.header.frame_id), fixed_frame_));
  }
}

void SemanticMapDisplay::update(float, float) {
  showPicture();
  place(grid_frame_, "Transform of areas");
  place(graph_frame_, "Transform of graph");
  place(plan_frame_, "Transform of plan");
}

}  // namespace agrid_map_rviz

PLUGINLIB_EXPORT_CLASS(agrid_map_rviz::SemanticMapDisplay, rviz::Display)

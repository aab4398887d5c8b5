// SPDX-License-Identifier: BSD-3-Clause
#include "tag_tool.h"

#include <QInputDialog>
#include <QKeyEvent>
#include <cmath>

#include <OgrePlane.h>
#include <OgreVector3.h>
#include <pluginlib/class_list_macros.hpp>
#include <rviz/display_context.h>
#include <rviz/geometry.h>
#include <rviz/ogre_helpers/line.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/string_property.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/viewport_mouse_event.h>

namespace agrid_map_rviz {
namespace {

using agrid_map::Tag;

/// A drag shorter than this is a click [m].
constexpr double kLeastDrag = 0.1;
/// Where the line of a drag is drawn [m].
constexpr float kLineHeight = 0.15F;

/// In the order of TagTool::Action.
constexpr const char* kActionNames[] = {"area", "door", "object", "split"};

/// The point of the floor under the mouse, in the fixed frame; nothing: it points at the sky.
std::optional<geometry_msgs::Point> floorUnder(const rviz::ViewportMouseEvent& event) {
  Ogre::Plane floor(Ogre::Vector3::UNIT_Z, 0.0F);
  Ogre::Vector3 hit;
  if (!rviz::getPointOnPlaneFromWindowXY(event.viewport, floor, event.x, event.y, hit)) return {};
  geometry_msgs::Point point;
  point.x = static_cast<double>(hit.x);
  point.y = static_cast<double>(hit.y);
  return point;
}

Ogre::Vector3 above(const geometry_msgs::Point& point) {
  return {static_cast<float>(point.x), static_cast<float>(point.y), kLineHeight};
}

}  // namespace

TagTool::TagTool() {
  shortcut_key_ = 'n';
  access_all_keys_ = true;
  node_ = new rviz::StringProperty("Node", "agrid", "The nodelet's name.", getPropertyContainer(),
                                   SLOT(useNode()), this);
  action_ = new rviz::EnumProperty("Action", "area", "What the mouse says: keys A, D, O, S.",
                                   getPropertyContainer(), SLOT(explain()), this);
  for (int i = kArea; i <= kSplit; ++i) action_->addOption(kActionNames[i], i);
}

TagTool::~TagTool() = default;

void TagTool::onInitialize() {
  setName("Tag");
  setDescription(tr("Tag areas, doors and objects of the map with the mouse"));
  setCursor(Qt::CrossCursor);
  line_ = std::make_unique<rviz::Line>(scene_manager_);
  line_->setColor(1.0F, 0.4F, 0.0F, 1.0F);
  line_->setVisible(false);
  useNode();
}

void TagTool::useNode() {
  std::string error;
  if (node_->getStdString().empty() || !ros::names::validate(node_->getStdString(), error)) {
    return setStatus(tr("'%1' is no name of a node").arg(node_->getString()));
  }
  if (session_) session_->disconnect(this);
  session_ = &EditSession::of(*context_, node_->getString());
  connect(session_, &EditSession::answered, this, [this](bool success, const QString& sentence) {
    if (active_) setStatus(success ? sentence : tr("<b>%1</b>").arg(sentence.toHtmlEscaped()));
  });
}

void TagTool::activate() {
  active_ = true;
  explain();
}

void TagTool::deactivate() {
  forgetDrag();
  active_ = false;
}

void TagTool::setAction(Action action) { action_->setValue(kActionNames[action]); }

void TagTool::explain() {
  forgetDrag();
  if (!active_) return;
  switch (action_->getOptionInt()) {
    case kArea:
      return setStatus(
          tr("<b>Click</b> into an area to name it. D: door, O: object, S: split, U: undo"));
    case kDoor:
      return setStatus(
          tr("<b>Drag</b> from jamb to jamb of a door. A: area, O: object, S: split, U: undo"));
    case kObject:
      return setStatus(tr("<b>Click</b> where the object is. A: area, D: door, S: split, U: undo"));
    default:
      return setStatus(
          tr("<b>Drag</b> from wall to wall across an area to part it there. U: undo"));
  }
}

std::string TagTool::frame() const { return context_->getFixedFrame().toStdString(); }

int TagTool::processMouseEvent(rviz::ViewportMouseEvent& event) {
  const bool left = event.acting_button == Qt::LeftButton || event.left();
  if (!left) {
    // the other buttons move the view, as without the tool
    if (event.panel->getViewController()) event.panel->getViewController()->handleMouseEvent(event);
    return 0;
  }
  const auto point = floorUnder(event);
  if (!point) return 0;
  const int action = action_->getOptionInt();
  if (action == kDoor || action == kSplit) {
    drag(event, *point);
  } else if (event.leftUp()) {
    click(event.panel, *point);
  }
  return Render;
}

void TagTool::drag(rviz::ViewportMouseEvent& event, const geometry_msgs::Point& point) {
  if (event.leftDown()) drag_start_ = point;
  if (!drag_start_) return;
  line_->setPoints(above(*drag_start_), above(point));
  line_->setVisible(true);
  if (event.leftUp()) putDoor(point);
}

void TagTool::forgetDrag() {
  drag_start_.reset();
  if (line_) line_->setVisible(false);
}

void TagTool::putDoor(const geometry_msgs::Point& end) {
  const geometry_msgs::Point start = *drag_start_;
  forgetDrag();
  if (std::hypot(end.x - start.x, end.y - start.y) < kLeastDrag) {
    return setStatus(tr("<b>Drag</b> from one jamb to the other"));
  }
  auto request = doorBetween(frame(), start, end);
  // a door is sought near the line, a border lies where it was drawn
  request.force = action_->getOptionInt() == kSplit;
  session_->apply(request.force ? tr("parted") : tr("door put"), {request});
}

void TagTool::click(rviz::RenderPanel* panel, const geometry_msgs::Point& point) {
  const auto action = static_cast<Action>(action_->getOptionInt());
  auto* dialog = new QInputDialog(panel);
  dialog->setObjectName("tag_name");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(action == kArea ? tr("Area") : tr("Object"));
  dialog->setLabelText(action == kArea ? tr("What is this area called?")
                                       : tr("What is it? (fridge, printer ...)"));
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, action, point](const QString& name) { putTag(action, point, name.trimmed()); });
  dialog->open();
}

void TagTool::putTag(Action action, const geometry_msgs::Point& point, const QString& name) {
  if (name.isEmpty()) return setStatus(tr("<b>Nothing was tagged</b>: it needs a name"));
  auto request = tagAt(action == kArea ? Tag::AREA : Tag::OBJECT, frame(), point.x, point.y);
  // an object is called by its category: fridge, fridge_2 ...
  (action == kArea ? request.tag.name : request.tag.category) = name.toStdString();
  session_->apply(tr("%1 put").arg(name), {request});
}

int TagTool::processKeyEvent(QKeyEvent* event, rviz::RenderPanel* panel) {
  const bool undo = event->key() == Qt::Key_U ||
                    (event->key() == Qt::Key_Z && event->modifiers() & Qt::ControlModifier);
  if (undo) {
    session_->undo();
  } else if (event->key() == Qt::Key_A) {
    setAction(kArea);
  } else if (event->key() == Qt::Key_D) {
    setAction(kDoor);
  } else if (event->key() == Qt::Key_O) {
    setAction(kObject);
  } else if (event->key() == Qt::Key_S) {
    setAction(kSplit);
  } else {
    return rviz::Tool::processKeyEvent(event, panel);
  }
  return Render;
}

}  // namespace agrid_map_rviz

PLUGINLIB_EXPORT_CLASS(agrid_map_rviz::TagTool, rviz::Tool)

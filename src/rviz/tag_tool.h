// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPointer>
#include <memory>
#include <optional>

#ifndef Q_MOC_RUN
#include <geometry_msgs/Point.h>
#include <rviz/tool.h>
#endif

#include "edit_session.h"

namespace rviz {
class EnumProperty;
class Line;
class StringProperty;
}  // namespace rviz

namespace agrid_map_rviz {

/// RViz tool: says with the mouse what is where. A click tags an area or drops an object, a drag
/// puts a door between two jambs or parts an area. Keys, while it is active: A area, D door,
/// S split, O object, U or Ctrl+Z takes back, Escape leaves.
class TagTool : public rviz::Tool {
  Q_OBJECT

 public:
  TagTool();
  ~TagTool() override;

  void onInitialize() override;
  void activate() override;
  void deactivate() override;
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;
  int processKeyEvent(QKeyEvent* event, rviz::RenderPanel* panel) override;

 private Q_SLOTS:
  void useNode();
  void explain();

 private:
  enum Action { kArea, kDoor, kObject, kSplit };

  void setAction(Action action);
  void drag(rviz::ViewportMouseEvent& event, const geometry_msgs::Point& point);
  void click(rviz::RenderPanel* panel, const geometry_msgs::Point& point);
  void putTag(Action action, const geometry_msgs::Point& point, const QString& name);
  void putDoor(const geometry_msgs::Point& end);
  void forgetDrag();
  std::string frame() const;

  rviz::StringProperty* node_;
  rviz::EnumProperty* action_;
  QPointer<EditSession> session_;
  std::unique_ptr<rviz::Line> line_;
  std::optional<geometry_msgs::Point> drag_start_;
  bool active_ = false;
};

}  // namespace agrid_map_rviz

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <rviz/properties/property.h>
#include <rviz/render_panel.h>
#include <rviz/tool_manager.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

#include <agrid_map/AddTag.h>
#include <agrid_map/ListTags.h>
#include <agrid_map/RemoveTag.h>

#include "ros/nodelet_client.h"

namespace agrid_map_rviz::test {

/// RViz with rviz/agrid.rviz, looking at the nodelet of agrid_rviz.test, which has the two rooms.
/// The window is made once: starting it takes seconds.
class RvizWindow : public agrid_map_ros::test::NodeletClient {
 public:
  /// Opens and closes the window that all tests share.
  static void open();
  static void close();

 protected:
  void SetUp() override;

  /// Lets the window live until something is true; fails after a generous time.
  static bool comesTrue(const std::function<bool()>& condition);

  /// A widget of the panel, by its name; never nullptr.
  template <typename Widget>
  static Widget* widget(const char* name) {
    auto* found = frame_->findChild<Widget*>(name);
    if (!found) throw std::runtime_error(std::string("no widget called ") + name);
    return found;
  }
  static QTreeWidget* list();
  static void press(const char* button);
  /// The line of the list that bears a name; nullptr: none.
  static QTreeWidgetItem* line(const QString& name);
  /// Clicks the lines of these names.
  static void choose(const std::vector<QString>& names);
  /// Types into the editor that is open in the list, and Enter.
  static void type(const QString& text);
  static QString answer();

  static rviz::RenderPanel* view() { return frame_->getManager()->getRenderPanel(); }
  static rviz::Tool* tool(const QString& class_id);
  /// Where a point of the map is in the view.
  static QPoint pixelOf(double x, double y);
  static void click(double x, double y);
  static void drag(double x1, double y1, double x2, double y2);
  /// What the view shows.
  static QImage picture();

  agrid_map::TopologicalGraph now() { return graph(); }
  std::vector<agrid_map::Tag> given(std::uint8_t type);
  /// The name of the area at a point; empty: none is there.
  QString areaAt(double x, double y);
  bool becomesCalled(double x, double y, const QString& name);
  /// Whether the graph gets this many areas.
  bool areasBecome(std::size_t count);

  static rviz::VisualizationFrame* frame_;  ///< what is open
};

}  // namespace agrid_map_rviz::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPointer>
#include <memory>
#include <mutex>
#include <optional>

#ifndef Q_MOC_RUN
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <rviz/display.h>

#include <agrid_map/AGrid.h>
#include <agrid_map/TopologicalGraph.h>

#include "layers.h"
#endif

#include "edit_session.h"

namespace rviz {
class BoolProperty;
class FloatProperty;
class StringProperty;
}  // namespace rviz

namespace agrid_map_rviz {

/// RViz display: the meaning of a map as a node of this package publishes it. Each part has a
/// switch. Areas are one textured face, painted off the render path, so that their cost does not
/// grow with the number of cells.
class SemanticMapDisplay : public rviz::Display {
  Q_OBJECT

 public:
  SemanticMapDisplay();
  ~SemanticMapDisplay() override;

  void onInitialize() override;
  void update(float wall_dt, float ros_dt) override;
  void reset() override;

 protected:
  void onEnable() override;
  void onDisable() override;

 private Q_SLOTS:
  void resubscribe();
  void updateVisibility();
  void updateAlpha();
  void updateNames();

 private:
  /// An A-Grid ready to be drawn.
  struct Picture {
    std_msgs::Header header;
    geometry_msgs::Pose origin;
    AreaPicture areas;
    Mesh cells;
    std::size_t cell_count;
  };
  /// Each kind of message has a node of its own: they may come in different frames.
  struct Framed {
    Ogre::SceneNode* node = nullptr;
    std_msgs::Header header;
    geometry_msgs::Pose pose;  ///< in the header's frame
  };

  void subscribe();
  void unsubscribe();
  void paint(const agrid_map::AGrid::ConstPtr& grid);
  void showPicture();
  void showGraph(const agrid_map::TopologicalGraph::ConstPtr& graph);
  void showRoute(const agrid_map::Route& route);
  void showPlan(const nav_msgs::Path::ConstPtr& plan);
  void place(const Framed& framed, const QString& name);

  rviz::StringProperty* node_;
  rviz::FloatProperty *alpha_, *name_size_;
  rviz::BoolProperty *areas_on_, *names_on_, *doors_on_, *objects_on_, *pending_on_, *graph_on_,
      *route_on_, *plan_on_, *cells_on_;
  Framed grid_frame_, graph_frame_, plan_frame_;
  std::unique_ptr<AreaLayer> areas_;
  std::unique_ptr<ShapeLayer> cells_, edges_, doors_, objects_, pending_, route_, plan_;
  std::unique_ptr<NameLayer> names_;
  agrid_map::TopologicalGraph::ConstPtr graph_;
  agrid_map::Route chosen_;  ///< of the ways that the panel lists
  QPointer<EditSession> session_;
  ros::Subscriber grid_subscriber_, graph_subscriber_, plan_subscriber_;
  std::mutex mutex_;
  std::unique_ptr<Picture> painted_;  ///< guarded by mutex_: made by another thread
};

}  // namespace agrid_map_rviz

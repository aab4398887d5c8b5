// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include <costmap_2d/GenericPluginConfig.h>
#include <costmap_2d/layer.h>
#include <costmap_2d/layered_costmap.h>
#include <dynamic_reconfigure/server.h>

#include "agrid/planning/costmap_areas.h"
#include "plugins/nodelet_client.h"

namespace agrid_map_plugins {

/// What tags say about where to drive, as a layer of a costmap, before the inflation layer: closed
/// doors and forbidden areas are obstacles, areas to be avoided cost more. Follows `~graph` of the
/// nodelet.
///
/// Parameters (~NAME/...): `nodelet` (agrid), `enabled` (true), `require_graph` (true: the costmap
/// is not current before the first graph, so that the robot waits), `neutral_cost` (50) and
/// `cost_factor` (3) of the global planner, by which an area's factor becomes a cost.
class AreaLayer : public costmap_2d::Layer {
 public:
  AreaLayer();

  void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x, double* min_y,
                    double* max_x, double* max_y) override;
  void updateCosts(costmap_2d::Costmap2D& master, int min_i, int min_j, int max_i,
                   int max_j) override;
  void matchSize() override { drawn_.reset(); }
  void reset() override { drawn_.reset(); }

 private:
  void onInitialize() override;
  std::optional<agrid::AreaCosts> areasNow(const agrid::Point2& robot) const;

  std::unique_ptr<NodeletClient> nodelet_;
  std::unique_ptr<agrid::CurrentAreas> areas_;
  std::optional<agrid::AreaCosts> drawn_;  ///< what the costmap shows; none: nothing yet
  bool require_graph_ = true;
  std::unique_ptr<dynamic_reconfigure::Server<costmap_2d::GenericPluginConfig>> switch_;
};

}  // namespace agrid_map_plugins

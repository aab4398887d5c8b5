// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <utility>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/steady_timer.h>
#include <tf2/buffer_core.h>

#include <agrid_map/Area.h>

#include "ros/event_log.h"
#include "ros/place_keeper.h"

namespace agrid_map_ros {

/// Publishes ~current_area, latched, whenever the robot is in another area than before or the map
/// is new, if TF knows where the robot is. Outside every area: an Area with id 0.
class AreaWatch {
 public:
  /// All must outlive this.
  struct Deps {
    const PlaceKeeper& keeper;
    const tf2::BufferCore& transforms;
    const std::atomic<bool>& cancelled;
    EventLog& log;
  };
  AreaWatch(ros::NodeHandle& private_nh, const Deps& deps, double period_seconds);

 private:
  using Seen = std::pair<std::uint32_t, std::uint32_t>;  // version of the map, id of the area

  void look();

  Deps deps_;
  ros::Publisher publisher_;
  std::optional<Seen> last_;
  ros::SteadyTimer timer_;  // last: its callback uses the others
};

}  // namespace agrid_map_ros

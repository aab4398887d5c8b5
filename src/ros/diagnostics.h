// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/steady_timer.h>

#include "ros/event_log.h"
#include "ros/map_builder.h"
#include "ros/settings.h"

namespace agrid_map_ros {

/// What /diagnostics says of a node.
struct Findings {
  std::string parameter_error;  ///< empty: the parameters are fine
  std::string storage_problem;  ///< why nothing can be kept; empty: it can
  MapBuilder::State state = MapBuilder::State::kWaiting;
  SnapshotPtr snapshot;  ///< nullptr: no map yet
};
diagnostic_msgs::DiagnosticStatus diagnose(const Findings& findings, const EventLog& log);

/// Publishes /diagnostics once a second.
class Diagnostics {
 public:
  /// All must outlive this.
  struct Deps {
    const Settings& settings;
    const PlaceKeeper& keeper;
    const MapBuilder& builder;
    EventLog& log;
  };
  Diagnostics(ros::NodeHandle& private_nh, const Deps& deps);

 private:
  void publish();

  Deps deps_;
  std::string node_name_;
  ros::Publisher publisher_;
  ros::SteadyTimer timer_;  // last: its callback uses the others
};

}  // namespace agrid_map_ros

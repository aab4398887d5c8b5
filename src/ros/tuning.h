// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>

#include <dynamic_reconfigure/server.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include "agrid_map/AGridConfig.h"
#include "ros/event_log.h"
#include "ros/map_builder.h"
#include "ros/settings.h"

namespace agrid_map_ros {

/// Changes of parameters while the node runs: all read anew by ~rebuild, some by
/// dynamic_reconfigure. What comes is checked together with all other parameters; if they are good
/// the map is built anew with them, else those in use stay, all of them.
class Tuning {
 public:
  /// All must outlive this.
  struct Deps {
    Settings& settings;
    MapBuilder& builder;
    EventLog& log;
  };
  Tuning(const ros::NodeHandle& private_nh, const Deps& deps);

 private:
  using Server = dynamic_reconfigure::Server<agrid_map::AGridConfig>;

  bool rebuild(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  /// Shows what the parameter server holds. Not before that is good: the server of
  /// dynamic_reconfigure writes what it read back, wrong types as defaults.
  void show();
  /// Takes what somebody set, or puts back what was.
  void change(agrid_map::AGridConfig& config);

  ros::NodeHandle nh_;
  Deps deps_;
  boost::recursive_mutex mutex_;  ///< of the server's callbacks
  agrid_map::AGridConfig shown_ = {};
  std::unique_ptr<Server> server_;
  ros::ServiceServer rebuild_;
};

}  // namespace agrid_map_ros

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "ros/event_log.h"
#include "ros/snapshot.h"

namespace agrid_map_ros {

/// The latched topics ~agrid, ~graph, ~markers, ~areas and ~plan. Safe to use from several threads.
class Outputs {
 public:
  /// @param log  must outlive this
  Outputs(ros::NodeHandle& private_nh, EventLog& log);
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Publishes it soon, from a thread of its own; of several that come meanwhile only the newest.
  void offer(const SnapshotPtr& snapshot);
  void publishPlan(const nav_msgs::Path& path);

 private:
  void run();
  void publish(const Snapshot& snapshot);

  EventLog& log_;
  ros::Publisher agrid_;
  ros::Publisher graph_;
  ros::Publisher markers_;
  ros::Publisher areas_;
  ros::Publisher plan_;
  std::mutex mutex_;
  std::condition_variable wake_;
  SnapshotPtr newest_;
  bool stopping_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace agrid_map_ros

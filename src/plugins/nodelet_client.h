// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <ros/ros.h>

#include <agrid_map/PlanPath.h>
#include <agrid_map/TopologicalGraph.h>

namespace agrid_map_plugins {

/// What a plugin knows of the nodelet that holds the map. Safe to use from several threads.
class NodeletClient {
 public:
  using GraphPtr = agrid_map::TopologicalGraph::ConstPtr;

  /// @param nodelet  its name, resolved in this node's namespace
  explicit NodeletClient(const std::string& nodelet);
  ~NodeletClient();
  NodeletClient(const NodeletClient&) = delete;
  NodeletClient& operator=(const NodeletClient&) = delete;

  /// The newest one; null as long as none has come.
  GraphPtr graph() const;

  /// Asks for a path on the static map.
  /// @param timeout  [s] of the wall clock
  /// @return none if there is no answer in time; while the nodelet still owes one, it is not asked
  std::optional<agrid_map::PlanPath::Response> plan(const agrid_map::PlanPath::Request& request,
                                                    double timeout);

 private:
  using Answer = std::optional<agrid_map::PlanPath::Response>;

  Answer call(agrid_map::PlanPath::Request request);

  mutable std::mutex mutex_;
  GraphPtr graph_;
  ros::NodeHandle node_;
  std::string service_;
  ros::ServiceClient client_;
  std::future<Answer> answer_;
  ros::Subscriber subscriber_;
};

}  // namespace agrid_map_plugins

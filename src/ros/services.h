// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>
#include <tf2/buffer_core.h>

#include "ros/event_log.h"
#include "ros/map_builder.h"
#include "ros/outputs.h"
#include "ros/plan_answers.h"
#include "ros/plan_gate.h"
#include "ros/settings.h"

namespace agrid_map_ros {

/// The services of the nodelet. Every callback returns true: the outcome is in the response, and no
/// exception gets past it. Plans have threads of their own, so that long ones hold up nothing else.
class Services {
 public:
  /// All must outlive this.
  struct Deps {
    Settings& settings;
    MapBuilder& builder;
    Outputs& outputs;
    EventLog& log;
    const tf2::BufferCore& transforms;
    const std::atomic<bool>& cancelled;  ///< set before this is destroyed
  };
  Services(const ros::NodeHandle& private_nh, const Deps& deps);
  /// Waits for the requests that are being answered.
  ~Services();
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;

 private:
  template <typename Service>
  using Answer =
      std::function<typename Service::Response(const Ground&, const typename Service::Request&)>;
  enum class Kind { kQuestion, kPlan };

  template <typename Service>
  void advertise(Kind kind, const std::string& name, Answer<Service> answer);
  template <typename Service>
  void serve(Kind kind, const Answer<Service>& answer, const typename Service::Request& request,
             typename Service::Response& response);
  SnapshotPtr requireSnapshot() const;
  agrid_map::PlanPath::Response planPath(const Ground& ground,
                                         const agrid_map::PlanPath::Request& request);
  nav_msgs::GetPlan::Response makePlan(const Ground& ground,
                                       const nav_msgs::GetPlan::Request& request);
  bool rebuild(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  Deps deps_;
  int max_plans_;
  PlanGate gate_;
  ros::CallbackQueue plan_queue_;
  ros::NodeHandle question_nh_;
  ros::NodeHandle plan_nh_;
  std::vector<ros::ServiceServer> servers_;
  ros::AsyncSpinner plan_spinner_;
};

}  // namespace agrid_map_ros

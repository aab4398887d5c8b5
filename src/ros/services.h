// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <tf2/buffer_core.h>

#include "ros/event_log.h"
#include "ros/hearing.h"
#include "ros/outputs.h"
#include "ros/place_keeper.h"
#include "ros/plan_answers.h"
#include "ros/request_queue.h"
#include "ros/settings.h"

namespace agrid_map_ros {

/// The services of the nodelet. Every callback returns true: the outcome is in the response, and no
/// exception gets past it. Plans and edits have threads and lines of their own, so that neither
/// long ones nor many hold up anything else; a plan is answered within its timeout, counted from
/// its arrival.
class Services {
 public:
  /// All must outlive this.
  struct Deps {
    const Settings& settings;
    PlaceKeeper& keeper;
    const Hearing& hearing;
    Outputs& outputs;
    EventLog& log;
    const tf2::BufferCore& transforms;
    const std::atomic<bool>& cancelled;  ///< set before this is destroyed
  };
  Services(const ros::NodeHandle& private_nh, const Deps& deps);
  /// Answers all requests that wait, as cancelled, and waits for those that are being answered.
  ~Services();
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;

 private:
  template <typename Service>
  using Answer =
      std::function<typename Service::Response(const Ground&, const typename Service::Request&)>;
  enum class Kind { kQuestion, kPlan, kEdit };
  template <typename Service>
  using EditAnswer = typename Service::Response (*)(const Ground&, PlaceKeeper&,
                                                    const typename Service::Request&);

  template <typename Service>
  void advertise(Kind kind, const std::string& name, Answer<Service> answer);
  template <typename Service>
  void serve(Kind kind, const Answer<Service>& answer, const typename Service::Request& request,
             typename Service::Response& response);
  /// The same for one that changes what is known.
  template <typename Service>
  void advertiseEdit(const std::string& name, EditAnswer<Service> answer);
  /// Answers one whose turn has come: how long it has waited.
  /// @throws RequestError if it is to be refused
  RequestQueue::Clock::duration requireTurn(Kind kind) const;
  SnapshotPtr requireSnapshot() const;
  agrid_map::PlanPath::Response planPath(const Ground& ground,
                                         const agrid_map::PlanPath::Request& request);
  nav_msgs::GetPlan::Response makePlan(const Ground& ground,
                                       const nav_msgs::GetPlan::Request& request);

  Deps deps_;
  RequestQueue::Limits plan_limits_;
  RequestQueue plan_queue_;
  RequestQueue edit_queue_;
  ros::NodeHandle question_nh_;
  ros::NodeHandle plan_nh_;
  ros::NodeHandle edit_nh_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace agrid_map_ros

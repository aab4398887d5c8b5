// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>

#include <nav_msgs/GetPlan.h>

#include <agrid_map/PlanAreas.h>
#include <agrid_map/PlanPath.h>

#include "ros/frames.h"
#include "ros/snapshot.h"

namespace agrid_map_ros {

/// What a request is answered from.
struct Ground {
  const Snapshot& snapshot;
  const Frames& frames;                ///< into the snapshot's frame
  const std::atomic<bool>& cancelled;  ///< planning ends when it becomes true
  /// By the request for its turn; a part of its timeout.
  std::chrono::steady_clock::duration waited{};
};

/// The answers to the planning services; a plan that fails has its status in the response.
/// @throws RequestError, LookupError if the request cannot be understood
agrid_map::PlanAreas::Response answerPlanAreas(const Ground& ground,
                                               const agrid_map::PlanAreas::Request& request);
agrid_map::PlanPath::Response answerPlanPath(const Ground& ground,
                                             const agrid_map::PlanPath::Request& request);
/// @throws RequestError also if there is no plan, as nav_msgs/GetPlan cannot say why
nav_msgs::GetPlan::Response answerMakePlan(const Ground& ground,
                                           const nav_msgs::GetPlan::Request& request);

/// Says if an answer is right for what it was made from, but not for the newest: whether a newer
/// map has been built meanwhile, or an edit has changed what is known about the same one.
/// @param newest  nullptr if there is none any more
void remarkChange(agrid_map::Status& status, const Snapshot& used, const Snapshot* newest);

}  // namespace agrid_map_ros

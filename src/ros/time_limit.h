// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace agrid_map_ros {

/// When a request must have been answered: its timeout counts from its arrival, whatever it waits
/// for and however many plans it takes.
class TimeLimit {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param asked      the request's timeout [s]; 0: the parameter
  /// @param parameter  [s]
  /// @param waited     how long the request has waited for its turn
  TimeLimit(double asked, double parameter, Clock::duration waited);

  Clock::time_point deadline() const { return deadline_; }
  bool isOver() const { return Clock::now() >= deadline_; }
  /// @throws RequestError TIMEOUT if it is over
  void requireTime() const;
  /// What a plan may still take, for PlanRequest::timeout [s], above 0; a timeout out of its bounds
  /// as it is, for the planner to refuse.
  double left() const;

 private:
  double timeout_seconds_;
  Clock::time_point deadline_;
};

}  // namespace agrid_map_ros

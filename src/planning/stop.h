// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>

#include "agrid/planning/planner.h"

namespace agrid::planning {

/// Thrown where work ends early; caught in Planner, never seen outside.
struct Stopped {
  PlanStatus status = PlanStatus::kTimeout;
};

/// When to end early: a point of the steady clock, or a flag set by another thread.
struct StopCheck {
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  const std::atomic<bool>* cancelled = nullptr;

  bool isCancelled() const { return cancelled != nullptr && cancelled->load(); }
  bool isLate() const { return std::chrono::steady_clock::now() >= deadline; }
  /// @throws Stopped
  void check() const {
    if (isCancelled()) throw Stopped{PlanStatus::kCancelled};
    if (isLate()) throw Stopped{PlanStatus::kTimeout};
  }
};

}  // namespace agrid::planning

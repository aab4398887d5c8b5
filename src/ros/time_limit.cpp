// SPDX-License-Identifier: BSD-3-Clause
#include "ros/time_limit.h"

#include <algorithm>

#include "ros/request_error.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

constexpr double kMaxSeconds = 60;  // the planner's own bound
constexpr double kLeast = 1e-9;     // enough for the planner to say that the time is over

bool isValid(double seconds) { return seconds > 0 && seconds <= kMaxSeconds; }

}  // namespace

TimeLimit::TimeLimit(double asked, double parameter, Clock::duration waited)
    : timeout_seconds_(asked == 0 ? parameter : asked),
      deadline_(Clock::now() - waited +
                std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                    isValid(timeout_seconds_) ? timeout_seconds_ : kMaxSeconds))) {}

void TimeLimit::requireTime() const {
  if (!isOver()) return;
  throw RequestError(agrid_map::Status::TIMEOUT,
                     "no answer within " + formatNumber(timeout_seconds_) + " s");
}

double TimeLimit::left() const {
  if (!isValid(timeout_seconds_)) return timeout_seconds_;
  return std::max(kLeast, std::chrono::duration<double>(deadline_ - Clock::now()).count());
}

}  // namespace agrid_map_ros

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <agrid_map/Status.h>

#include "ros/event_log.h"

namespace agrid_map_ros {

/// What the exception that is being handled means to whoever asked. One that is no refusal, but
/// stands for a mistake of ours or of a library, is written to the log as an error and counted.
agrid_map::Status caught(EventLog& log, const std::string& kind) noexcept;

/// Runs what roscpp or a thread calls: no exception gets past it, since it would end the process.
/// @param kind  for the log, see EventLog
/// @return why it was left; none: it ran to its end
template <typename Callback>
std::optional<agrid_map::Status> attempt(EventLog& log, const std::string& kind,
                                         Callback&& callback) {
  try {
    std::forward<Callback>(callback)();
    return std::nullopt;
  } catch (...) {
    return caught(log, kind);
  }
}

}  // namespace agrid_map_ros

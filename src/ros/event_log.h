// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace agrid_map_ros {

/// Writes what went wrong to the ROS log, each kind at most once a second by a steady clock (the
/// ROS clock may stand still), without control characters. Safe to use from several threads.
class EventLog {
 public:
  /// @param kind  short and fixed, e.g. "map"
  void warn(const std::string& kind, const std::string& text);
  void error(const std::string& kind, const std::string& text);
  /// An error that came as an exception which nobody had reason to expect.
  void caught(const std::string& kind, const std::string& what);

  std::string lastError() const;      ///< empty: none yet
  std::uint64_t errorCount() const;   ///< also those that were not written
  std::uint64_t caughtCount() const;  ///< of them, unexpected exceptions

 private:
  bool due(const std::string& kind);

  mutable std::mutex mutex_;
  std::map<std::string, std::chrono::steady_clock::time_point> written_;
  std::string last_error_;
  std::uint64_t error_count_ = 0;
  std::uint64_t caught_count_ = 0;
};

}  // namespace agrid_map_ros

// SPDX-License-Identifier: BSD-3-Clause
#include "ros/event_log.h"

#include <ros/console.h>

#include "ros/text.h"

namespace agrid_map_ros {
namespace {

constexpr std::size_t kLongestLine = 1000;  // bytes

std::string line(const std::string& kind, const std::string& text) {
  return kind + ": " + printable(text.substr(0, kLongestLine));
}

}  // namespace

void EventLog::warn(const std::string& kind, const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // warnings that come together differ, so each text has its own second
  if (due(kind + text.substr(0, 80))) ROS_WARN_STREAM(line(kind, text));
}

void EventLog::error(const std::string& kind, const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  last_error_ = line(kind, text);
  ++error_count_;
  if (due(kind)) ROS_ERROR_STREAM(last_error_);
}

void EventLog::caught(const std::string& kind, const std::string& what) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++caught_count_;
  }
  error(kind, "unexpected exception: " + what);
}

std::string EventLog::lastError() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_error_;
}

std::uint64_t EventLog::errorCount() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return error_count_;
}

std::uint64_t EventLog::caughtCount() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return caught_count_;
}

bool EventLog::due(const std::string& kind) {
  const auto now = std::chrono::steady_clock::now();
  // what was written long ago need not be remembered, so the table stays small
  for (auto entry = written_.begin(); entry != written_.end();) {
    entry = now - entry->second >= std::chrono::seconds(1) ? written_.erase(entry) : ++entry;
  }
  return written_.size() < 100 && written_.emplace(kind, now).second;
}

}  // namespace agrid_map_ros

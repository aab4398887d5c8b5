// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace agrid::tools {

/// What a stage of the work took.
struct StageCost {
  std::string stage;
  double seconds = 0;
  double peak_megabytes = 0;  ///< largest resident memory of the process during the stage
};

/// Measures stages one after another, and names the running one on standard error where that is a
/// terminal.
class StageMeter {
 public:
  explicit StageMeter(std::string command) : command_(std::move(command)) {}
  ~StageMeter();
  StageMeter(const StageMeter&) = delete;
  StageMeter& operator=(const StageMeter&) = delete;

  /// Ends the running stage and begins the next.
  void begin(const std::string& stage);
  /// Ends the running stage.
  void end();
  const std::vector<StageCost>& costs() const { return costs_; }

 private:
  std::string command_;
  bool running_ = false;
  std::chrono::steady_clock::time_point start_;
  std::vector<StageCost> costs_;
};

}  // namespace agrid::tools

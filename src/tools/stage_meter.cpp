// SPDX-License-Identifier: BSD-3-Clause
#include "tools/stage_meter.h"

#include <fstream>
#include <iostream>

#include <unistd.h>

namespace agrid::tools {
namespace {

/// Linux forgets the peak so far when 5 is written there; elsewhere the peak just keeps growing.
void forgetPeak() { std::ofstream("/proc/self/clear_refs") << "5"; }

double peakMegabytes() {
  std::ifstream status("/proc/self/status");
  std::string key;
  while (status >> key) {
    double kibibytes = 0;
    if (key == "VmHWM:" && status >> kibibytes) return kibibytes / 1024;
  }
  return 0;
}

void showProgress(const std::string& text) {
  if (isatty(STDERR_FILENO)) std::cerr << "\r\033[K" << text << std::flush;
}

}  // namespace

StageMeter::~StageMeter() {
  if (running_) showProgress("");
}

void StageMeter::begin(const std::string& stage) {
  end();
  showProgress(command_ + ": " + stage + " ...");
  costs_.push_back({stage, 0, 0});
  running_ = true;
  forgetPeak();
  start_ = std::chrono::steady_clock::now();
}

void StageMeter::end() {
  if (!running_) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  costs_.back().seconds = elapsed.count();
  costs_.back().peak_megabytes = peakMegabytes();
  running_ = false;
  showProgress("");
}

}  // namespace agrid::tools

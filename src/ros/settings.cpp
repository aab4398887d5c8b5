// SPDX-License-Identifier: BSD-3-Clause
#include "ros/settings.h"

#include <utility>

#include <ros/param.h>

namespace agrid_map_ros {

Settings::Settings(std::string ns, EventLog& log) : ns_(std::move(ns)), log_(log) {}

std::string Settings::reload() {
  XmlRpc::XmlRpcValue values;
  ros::param::get(ns_, values);
  const ParameterReading reading = readParameters(values);
  for (const std::string& warning : reading.warnings) log_.warn("parameters", warning);
  std::string error;
  for (const std::string& one : reading.errors) error += (error.empty() ? "" : "; ") + one;
  if (!error.empty()) log_.error("parameters", error);
  const bool taken = error.empty() || !reading.parameters.node.strict_params;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (taken) parameters_ = std::make_shared<const Parameters>(reading.parameters);
  error_ = taken ? std::string() : error;
  return error_;
}

std::shared_ptr<const Parameters> Settings::parameters() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return parameters_;
}

std::string Settings::error() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return error_;
}

}  // namespace agrid_map_ros

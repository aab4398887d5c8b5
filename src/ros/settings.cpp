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
  const std::string error = said(reading.errors);
  const bool taken = error.empty() || !reading.parameters.node.strict_params;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (taken) parameters_ = std::make_shared<const Parameters>(reading.parameters);
  error_ = taken ? std::string() : error;
  return error_;
}

std::string Settings::change(const XmlRpc::XmlRpcValue& changed) {
  XmlRpc::XmlRpcValue values;
  ros::param::get(ns_, values);
  XmlRpc::XmlRpcValue copy = changed;  // XmlRpcValue can only be read where it can be changed
  for (auto& [name, value] : copy) values[name] = value;
  const ParameterReading reading = readParameters(values);
  const std::string error = said(reading.errors);
  if (!error.empty()) return error;
  const std::lock_guard<std::mutex> lock(mutex_);
  parameters_ = std::make_shared<const Parameters>(reading.parameters);
  error_.clear();
  return error;
}

std::string Settings::said(const std::vector<std::string>& errors) {
  std::string error;
  for (const std::string& one : errors) error += (error.empty() ? "" : "; ") + one;
  if (!error.empty()) log_.error("parameters", error);
  return error;
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

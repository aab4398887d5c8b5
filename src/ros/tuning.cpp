// SPDX-License-Identifier: BSD-3-Clause
#include "ros/tuning.h"

#include <cstdint>

#include "ros/boundary.h"
#include "ros/request_error.h"

namespace agrid_map_ros {
namespace {

using agrid_map::AGridConfig;
using agrid_map::Status;

constexpr std::uint32_t kAllLevels = ~0U;

template <typename Entries>
void put(const Entries& entries, XmlRpc::XmlRpcValue& values) {
  for (const auto& entry : entries) values[entry.name] = entry.value;
}

XmlRpc::XmlRpcValue valuesOf(const AGridConfig& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  XmlRpc::XmlRpcValue values;
  put(message.ints, values);
  put(message.strs, values);
  put(message.doubles, values);
  for (const auto& entry : message.bools) values[entry.name] = entry.value != 0;
  return values;
}

}  // namespace

Tuning::Tuning(const ros::NodeHandle& private_nh, const Deps& deps) : nh_(private_nh), deps_(deps) {
  if (deps_.settings.error().empty()) show();
  rebuild_ = nh_.advertiseService("rebuild", &Tuning::rebuild, this);
}

bool Tuning::rebuild(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const boost::recursive_mutex::scoped_lock lock(mutex_);
  const auto failure = attempt(deps_.log, "rebuild", [&] {
    const std::string error = deps_.settings.reload();
    if (!error.empty()) throw RequestError(Status::INVALID_REQUEST, error);
    show();
    deps_.builder.setParameters(deps_.settings.parameters());
    if (!deps_.builder.rebuild()) throw RequestError(Status::NO_MAP, "no map has arrived yet");
    response.success = true;
    response.message = "the map is being built anew";
  });
  if (!failure) return true;
  response.success = false;
  response.message = failure->message;
  return true;
}

void Tuning::show() {
  shown_.__fromServer__(nh_);
  if (server_) return server_->updateConfig(shown_);
  server_ = std::make_unique<Server>(mutex_, nh_);
  server_->setCallback([this](AGridConfig& config, std::uint32_t level) {
    // it is called at once with what is in use
    if (level != kAllLevels) change(config);
  });
}

void Tuning::change(AGridConfig& config) {
  const std::string error = deps_.settings.change(valuesOf(config));
  if (!error.empty()) {
    config = shown_;
    return;
  }
  shown_ = config;
  deps_.builder.setParameters(deps_.settings.parameters());
  deps_.builder.rebuild();
}

}  // namespace agrid_map_ros

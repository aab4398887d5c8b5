// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/nodelet_client.h"

#include <chrono>
#include <utility>

namespace agrid_map_plugins {

NodeletClient::NodeletClient(const std::string& nodelet)
    : service_(node_.resolveName(nodelet + "/plan_path")) {
  subscriber_ = node_.subscribe<agrid_map::TopologicalGraph>(
      nodelet + "/graph", 1, [this](const GraphPtr& graph) {
        const std::lock_guard<std::mutex> lock(mutex_);
        graph_ = graph;
      });
}

NodeletClient::~NodeletClient() {
  subscriber_.shutdown();
  client_.shutdown();  // so that a call that hangs ends
}

NodeletClient::GraphPtr NodeletClient::graph() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return graph_;
}

NodeletClient::Answer NodeletClient::call(agrid_map::PlanPath::Request request) {
  agrid_map::PlanPath::Response response;
  if (!client_.isValid()) client_ = node_.serviceClient<agrid_map::PlanPath>(service_, true);
  if (!client_.call(request, response)) return std::nullopt;
  return response;
}

NodeletClient::Answer NodeletClient::plan(const agrid_map::PlanPath::Request& request,
                                          double timeout) {
  if (answer_.valid() && answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return std::nullopt;
  }
  // roscpp's calls have no time limit; a nodelet that hangs must not stop the robot's planner
  answer_ = std::async(std::launch::async, [this, request] { return call(request); });
  if (answer_.wait_for(std::chrono::duration<double>(timeout)) != std::future_status::ready) {
    return std::nullopt;
  }
  return answer_.get();
}

}  // namespace agrid_map_plugins

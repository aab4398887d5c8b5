// SPDX-License-Identifier: BSD-3-Clause
#include "ros/diagnostics.h"

#include <chrono>
#include <fstream>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <unistd.h>

#include "ros/boundary.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

using diagnostic_msgs::DiagnosticStatus;

void add(DiagnosticStatus& status, const std::string& key, const std::string& value) {
  status.values.emplace_back();
  status.values.back().key = key;
  status.values.back().value = value;
}

/// What the whole process keeps in memory [MB], as Linux says; 0 where it does not.
double processMemory() {
  std::ifstream file("/proc/self/statm");
  double size = 0;
  double resident = 0;
  file >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

void describe(DiagnosticStatus& status, const Snapshot& snapshot) {
  const agrid::SemanticMap& map = *snapshot.map;
  const std::chrono::duration<double> age = std::chrono::steady_clock::now() - snapshot.built;
  add(status, "map_id", map.map().digest());
  add(status, "frame", snapshot.frame());
  add(status, "version", std::to_string(snapshot.stamp.version));
  add(status, "age [s]", formatNumber(age.count()));
  add(status, "build time [s]", formatNumber(snapshot.build_seconds));
  add(status, "cells", std::to_string(map.grid().cellCount()));
  add(status, "areas", std::to_string(map.area_map.areas.size()));
  add(status, "unreachable areas",
      std::to_string(agrid::unreachableAreas(map.area_map, map.graph).size()));
  add(status, "doors", std::to_string(map.area_map.doors.size()));
  add(status, "objects", std::to_string(map.knowledge.objects.size()));
  add(status, "waiting tags", std::to_string(map.knowledge.pending.size()));
}

/// A sentence for the state and how bad it is.
void judge(DiagnosticStatus& status, MapBuilder::State state, bool has_map) {
  status.level = has_map ? DiagnosticStatus::OK : DiagnosticStatus::WARN;
  switch (state) {
    case MapBuilder::State::kWaiting:
      status.message = "waiting for a map";
      break;
    case MapBuilder::State::kBuilding:
      status.message = has_map ? "building a new map" : "building the first map";
      break;
    case MapBuilder::State::kReady:
      status.message = "ready";
      break;
    case MapBuilder::State::kFailed:
      status.level = has_map ? DiagnosticStatus::WARN : DiagnosticStatus::ERROR;
      status.message =
          has_map ? "the last map was refused, the former one is in use" : "the map was refused";
      break;
  }
}

}  // namespace

DiagnosticStatus diagnose(const Findings& findings, const EventLog& log) {
  DiagnosticStatus status;
  judge(status, findings.state, findings.snapshot != nullptr);
  if (!findings.storage_problem.empty()) {
    if (status.level == DiagnosticStatus::OK) status.level = DiagnosticStatus::WARN;
    status.message += "; what people say is not kept: " + findings.storage_problem;
  }
  if (!findings.parameter_error.empty()) {
    status.level = DiagnosticStatus::ERROR;
    status.message = "bad parameters: " + findings.parameter_error;
  }
  if (findings.snapshot) describe(status, *findings.snapshot);
  add(status, "process memory [MB]", formatNumber(processMemory()));
  add(status, "errors", std::to_string(log.errorCount()));
  add(status, "unexpected exceptions", std::to_string(log.caughtCount()));
  add(status, "last error", log.lastError());
  return status;
}

Diagnostics::Diagnostics(ros::NodeHandle& private_nh, const Deps& deps)
    : deps_(deps),
      node_name_(private_nh.getNamespace().substr(1)),
      publisher_(private_nh.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1)),
      timer_(
          private_nh.createSteadyTimer(ros::WallDuration(1), [this](const ros::SteadyTimerEvent&) {
            attempt(deps_.log, "diagnostics", [this] { publish(); });
          })) {}

void Diagnostics::publish() {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  array.status.push_back(diagnose({deps_.settings.error(), deps_.keeper.storageProblem(),
                                   deps_.builder.state(), deps_.keeper.snapshot()},
                                  deps_.log));
  array.status.back().name = node_name_ + ": map";
  publisher_.publish(array);
}

}  // namespace agrid_map_ros

// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/tags/tag.h"

#include <tuple>

namespace agrid {
namespace {

bool samePose(const Pose2& a, const Pose2& b) { return a.position == b.position && a.yaw == b.yaw; }

}  // namespace

bool operator==(const AreaTag& a, const AreaTag& b) {
  return std::tie(a.id, a.name, a.category, a.source, a.properties) ==
             std::tie(b.id, b.name, b.category, b.source, b.properties) &&
         a.seed_map == b.seed_map && a.outline_map == b.outline_map;
}

bool operator==(const DoorTag& a, const DoorTag& b) {
  return std::tie(a.id, a.name, a.width, a.state, a.source, a.properties, a.absent) ==
             std::tie(b.id, b.name, b.width, b.state, b.source, b.properties, b.absent) &&
         samePose(a.pose_map, b.pose_map);
}

bool operator==(const ObjectTag& a, const ObjectTag& b) {
  return std::tie(a.id, a.name, a.category, a.height, a.source, a.properties) ==
             std::tie(b.id, b.name, b.category, b.height, b.source, b.properties) &&
         samePose(a.pose_map, b.pose_map) && a.size == b.size;
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "agrid/planning/planner.h"
#include "agrid/semantic_map.h"
#include "agrid_map_ros/conversions.h"
#include "agrid_map_ros/parameters.h"

namespace agrid_map_ros {

/// All that a request needs to be answered; never changed after it was made.
struct Snapshot {
  std::shared_ptr<const agrid::SemanticMap> map;
  std::shared_ptr<const agrid::Planner> planner;
  std::shared_ptr<const Parameters> parameters;  ///< those it was made with
  Stamp stamp;                                   ///< header and version of all its messages
  double build_seconds = 0;
  std::chrono::steady_clock::time_point built;  ///< when it was made

  const std::string& frame() const { return stamp.header.frame_id; }
};

using SnapshotPtr = std::shared_ptr<const Snapshot>;

}  // namespace agrid_map_ros

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <XmlRpcValue.h>

#include "agrid/dialogue/replies.h"
#include "agrid/map/occupancy_map.h"
#include "agrid/pipeline.h"
#include "agrid/pipeline/edit.h"
#include "agrid/planning/planner.h"

namespace agrid_map_ros {

/// What concerns the nodelet alone.
struct NodeParams {
  std::string base_frame = "base_link";  ///< the robot's frame, for start_from_robot and the area
  double tf_timeout = 0.3;               ///< how long a request waits for a transform [s]
  double area_period = 0.5;              ///< between two looks at the robot's area [s]
  double static_map_wait = 5;  ///< without a map for so long, static_map is asked [s]; 0: never
  int max_parallel_plans = 0;  ///< plans at a time; 0: as many as there are cores; read at start
  int max_queued_plans = 100;  ///< plans that wait, further ones are answered BUSY; read at start
  bool strict_params = true;   ///< false: a bad parameter is logged and its default used
};

/// Where what people say is kept; read at start.
struct StorageParams {
  std::string directory;   ///< empty: agrid_map in $ROS_HOME or ~/.ros
  std::string name;        ///< of the file, without .yaml; empty: the node's name
  bool persistent = true;  ///< false: only in memory
  bool read_only = false;  ///< every edit is refused
};

/// How what people say is taken.
struct DialogueOptions {
  std::string click_tag;     ///< what a clicked point means; empty: nothing
  std::string grammar_file;  ///< of sentences; empty: English; read at start
};

/// Every parameter of the nodelet.
struct Parameters {
  agrid::MapParams map;
  agrid::PipelineParams pipeline;
  agrid::PlannerParams planner;
  agrid::EditParams edits;  ///< width of doors and size of clutter are those of the areas
  agrid::dialogue::DialogueParams dialogue;
  DialogueOptions hearing;
  StorageParams storage;
  NodeParams node;
};

/// What a private namespace says.
struct ParameterReading {
  Parameters parameters;              ///< defaults where nothing or something wrong is given
  std::vector<std::string> errors;    ///< wrong types and values out of range, a sentence each
  std::vector<std::string> warnings;  ///< names that mean nothing, with the nearest known one
};

/// Reads the parameters from the private namespace as the parameter server returns it.
/// @param values  a struct; anything that is not one counts as empty
ParameterReading readParameters(const XmlRpc::XmlRpcValue& values);

/// The names of all parameters, sorted.
std::vector<std::string> parameterNames();

}  // namespace agrid_map_ros

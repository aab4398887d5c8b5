// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/map/occupancy_map.h"
#include "agrid/pipeline.h"
#include "tools/arguments.h"

namespace agrid::tools {

/// Every parameter of the way from a map's file to its areas.
struct ConversionParams {
  MapParams map;
  PipelineParams pipeline;
};

/// The options that set them: --param KEY=VALUE, any number of times, and --method.
std::vector<Option> pipelineOptions();

/// The parameters as given. The keys are the names of the ROS parameters (doc/parameters.md).
/// @throws UsageError if a key is unknown or a value is none
ConversionParams conversionParams(const Arguments& arguments);

}  // namespace agrid::tools

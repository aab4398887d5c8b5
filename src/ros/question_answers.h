// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <agrid_map/GetAGrid.h>
#include <agrid_map/GetGraph.h>
#include <agrid_map/LabelAt.h>
#include <agrid_map/WhereIs.h>

#include "ros/plan_answers.h"

namespace agrid_map_ros {

/// The answers to questions about the map.
/// @throws RequestError, LookupError if there is none
agrid_map::LabelAt::Response answerLabelAt(const Ground& ground,
                                           const agrid_map::LabelAt::Request& request);
/// From a start where the robot cannot be, the distances are inf and the message says why.
agrid_map::WhereIs::Response answerWhereIs(const Ground& ground,
                                           const agrid_map::WhereIs::Request& request);
agrid_map::GetAGrid::Response answerGetAGrid(const Ground& ground,
                                             const agrid_map::GetAGrid::Request& request);
agrid_map::GetGraph::Response answerGetGraph(const Ground& ground,
                                             const agrid_map::GetGraph::Request& request);

}  // namespace agrid_map_ros

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "planning/free_space.h"
#include "planning/portal_graph.h"

namespace agrid::planning {

/// OMPL's view of free space: the plane, in pixels with pixel centres at integers. States and
/// motions are valid if their nearest points of the fine lattice see each other in `free`: exact,
/// no sampling along the motion. States are valid where a free pixel holds them.
/// @param free  must outlive the result
ompl::base::SpaceInformationPtr exactSpace(const FreeSpace& free);

/// Lets the space's samplers draw four of five samples from some boxes, evenly by their size, the
/// others from the whole map; reproducibly.
void guideSamplers(const ompl::base::SpaceInformationPtr& space, const std::vector<PixelBox>& boxes,
                   std::uint32_t seed);

FinePoint finePointOf(const ompl::base::State* state);
void setState(ompl::base::State* state, FinePoint point);

/// OMPL's messages go to a console that is not ours: none from now on, for the whole process.
void silenceOmpl();

}  // namespace agrid::planning

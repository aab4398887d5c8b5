// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/base/SpaceInformation.h>

#include "planning/ompl/space_motions.h"
#include "planning/ompl/swept_robot.h"

namespace agrid::planning {

/// Gives a space the bounds of a map, and the validity of states and motions by `robot`, without
/// sampling along the motions. States are in the map frame [m]. In the plane, motions are lines of
/// sight of FreeSpace. Does not set up the space.
/// @throws std::invalid_argument for a space that SpaceMotions does not know
void placeInMap(const ompl::base::SpaceInformationPtr& space,
                std::shared_ptr<const SweptRobot> robot);

}  // namespace agrid::planning

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/two_rooms.h"

namespace agrid_map_ros::test {

using agrid::test::twoRooms;

}  // namespace agrid_map_ros::test

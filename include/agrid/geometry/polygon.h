// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "agrid/geometry/point2.h"

namespace agrid {

/// Corners of a simple polygon [m], counter-clockwise, the first one not repeated at the end.
using Polygon = std::vector<Point2>;

}  // namespace agrid

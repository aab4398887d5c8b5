// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace agrid {

/// A point or a displacement in the plane [m]; the frame is part of the variable's name.
using Point2 = Eigen::Vector2d;

}  // namespace agrid

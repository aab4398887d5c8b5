// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace agrid {

/// The angle about z in (-pi, pi] of the quaternion (0, 0, z, w), whatever its norm. The one
/// formula for maps from files and from messages, so that both get the same angle, bit for bit.
inline double yawOfQuaternion(double z, double w) { return std::atan2(2 * w * z, w * w - z * z); }

}  // namespace agrid

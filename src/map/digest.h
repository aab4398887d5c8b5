// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "agrid/map/occupancy_map.h"

namespace agrid {

/// Fingerprint of a map: 64 bits over size, resolution, origin and pixels, as 16 hexadecimal
/// digits. Independent of the machine's byte order; -0.0 counts as 0.0. Not cryptographic: it tells
/// maps apart, it does not protect them.
std::string mapDigest(const MapGeometry& geometry, const std::vector<Occupancy>& pixels);

}  // namespace agrid

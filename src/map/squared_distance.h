// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "agrid/map/map_geometry.h"

namespace agrid {

/// Squared distances beyond this one are stored as this one [px^2].
constexpr std::int32_t kFarSquared = 0x7fffffff;

/// What lies around the pixels in which marked ones are looked for.
enum class Surroundings { kUnmarked, kMarked };

/// For each pixel the squared distance from its centre to the centre of the nearest marked pixel
/// [px^2], exact in integers up to kFarSquared (Meijster, Roerdink and Hesselink, "A general
/// algorithm for computing distance transforms in linear time", 2000).
/// @param marked  row-major, as large as the map; not 0: marked
/// @param take_row  is handed each row's number and squared distances, from the last row to the
///                  first; what it throws ends the work. kFarSquared everywhere if nothing is
///                  marked
void forEachRowOfSquaredDistances(
    const MapGeometry& geometry, const std::uint8_t* marked, Surroundings surroundings,
    const std::function<void(int y, const std::int32_t* squared)>& take_row);

/// The same as an array, with nothing marked around the map.
/// @param between_rows  called every few rows; what it throws ends the work
/// @return row-major
std::vector<std::int32_t> squaredDistances(const MapGeometry& geometry,
                                           const std::vector<std::uint8_t>& marked,
                                           const std::function<void()>& between_rows = {});

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "agrid/map/map_geometry.h"

namespace agrid {

/// The eight neighbours of a pixel, the four nearest first.
inline constexpr std::array<Pixel, 8> kNeighbours{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

inline Pixel operator+(Pixel a, Pixel b) { return {a.x + b.x, a.y + b.y}; }

}  // namespace agrid

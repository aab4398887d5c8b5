// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "map/image.h"
#include "map/map_yaml.h"

namespace agrid {

/// The occupancy values that map_server computes of an image, row 0 = the image's lowest row.
std::vector<std::int8_t> pixelValues(const Image& image, const PixelRule& rule);

}  // namespace agrid

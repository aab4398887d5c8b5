// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "agrid/map/map_geometry.h"

namespace agrid {

/// Labels per pixel (row 0 = smallest y) as a 16-bit image whose row 0 is the top.
cv::Mat labelImage(const std::vector<std::uint16_t>& labels, const MapGeometry& geometry);

}  // namespace agrid

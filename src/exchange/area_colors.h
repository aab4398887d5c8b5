// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "agrid/areas/area_map.h"

namespace agrid {

/// A light colour (BGR) for each area, in their order. An area keeps its colour from run to run by
/// its id; neighbours differ.
std::vector<cv::Vec3b> areaColors(const AreaMap& areas);

/// A darker shade of the same hue.
cv::Scalar darker(const cv::Vec3b& color);

}  // namespace agrid

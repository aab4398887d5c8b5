// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "agrid/areas/laid_tags.h"

namespace agrid {

struct AutomaticAreas {
  AreaMap area_map;              ///< its ids count areas and doors; they mean nothing outside
  std::vector<cv::Rect> boxes;   ///< of the pixels of each area
  double min_area_size = 0;      ///< [m^2]; what a door cuts off must be this large to be an area
  double min_border_length = 0;  ///< shorter borders are no doors [m]
};

}  // namespace agrid

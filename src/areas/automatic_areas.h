// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "agrid/areas/laid_tags.h"
#include "areas/cell_shares.h"
#include "tags/pixel_runs.h"

namespace agrid {

struct AutomaticAreas {
  AreaMap area_map;  ///< its ids count areas and doors; they mean nothing outside
  std::vector<std::vector<PixelRun>> runs;  ///< of the pixels of each area, row by row
  std::vector<cv::Rect> boxes;              ///< of the pixels of each area
  std::vector<double> mean_clearances;      ///< of each area's pixels, from what is not free [m]
  CellShares cell_shares;                   ///< how many pixels of each cell each area has
  double min_area_size = 0;      ///< [m^2]; what a door cuts off must be this large to be an area
  double min_border_length = 0;  ///< shorter borders are no doors [m]
  double max_door_width = 0;     ///< wider borders are passages [m]
};

}  // namespace agrid

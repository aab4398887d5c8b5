// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace agrid {

/// Grows areas as the paper does (3.2): OpenCV's watershed over the contours, walls and closed
/// doors being the ridges, then the opening operator on each area.
/// @param free_space  1 = free, 0 = contour
/// @param seeds  free pixels, row-major indices
/// @param opening_px  side of the opening's square
/// @return row-major: the number of the seed that each free pixel belongs to, or Basins::kNone
std::vector<std::uint32_t> floodContours(const cv::Mat1b& free_space,
                                         const std::vector<std::size_t>& seeds, int opening_px);

}  // namespace agrid

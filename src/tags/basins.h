// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace agrid {

/// What drains uphill to one peak of the relief.
struct Basin {
  std::size_t peak = 0;     ///< index of the pixel, row-major
  float height = 0;         ///< of the peak [px]
  std::size_t size_px = 0;  ///< its pixels
};

/// The highest way from one basin to another; a < b.
struct Saddle {
  float height = 0;  ///< [px]
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::size_t pixel = 0;  ///< the lowest pixel of that way, row-major index
};

/// The watershed of a relief before anything is merged.
struct Basins {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<Basin> basins;  ///< in row-major order of their first pixel
  std::vector<std::uint32_t>
      of_pixel;                 ///< row-major: index into `basins`, or kNone where the relief is 0
  std::vector<Saddle> saddles;  ///< from the highest to the lowest, ties by a, then b
};

/// Splits a relief into its basins: each pixel belongs to the peak that the steepest ascent leads
/// to, over its eight neighbours; pixels of a plateau go to the nearest way up (Meyer's watershed,
/// paper ref. 16, seen from above). Takes time linear in the pixels.
/// @param relief  row-major, 0 = not part of it
Basins findBasins(const cv::Mat1f& relief);

}  // namespace agrid

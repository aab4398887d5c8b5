// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "agrid/geometry/point2.h"

namespace agrid::bench {

/// Which pixels of a map's image a robot's centre may cross, found without any code of the package.
/// Row 0 is the top of the image; points are in pixels, pixel centres at integers, y down.
struct Ground {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> free;        ///< row-major
  std::vector<std::int32_t> components;  ///< of the free pixels by their sides, 0: not free

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  bool isFree(int x, int y) const { return contains(x, y) && free[index(x, y)] != 0; }
  /// 0 outside the map.
  std::int32_t componentAt(const Point2& p_px) const;
  bool connects(const Point2& a_px, const Point2& b_px) const;
};

/// Times of an exact cv::distanceTransform of an image's free pixels, on one thread.
/// @throws std::runtime_error if the image cannot be read
std::vector<double> transformSeconds(const std::string& image_path);

/// A pixel of the image is free if it is not on the outermost ring and its centre is more than
/// `radius_px` from the centre of every pixel darker than 250.
/// @throws std::runtime_error if the image cannot be read
Ground readGround(const std::string& image_path, double radius_px);

/// Whether every pixel whose closed square the segment touches is free. Decided exactly for points
/// on a lattice of 1/32768 pixel; others are rounded to it.
bool segmentIsFree(const Ground& ground, const Point2& a_px, const Point2& b_px);

}  // namespace agrid::bench

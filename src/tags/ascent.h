// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "tags/pixel_neighbours.h"

namespace agrid {

/// The way up from each pixel of a relief: to the neighbour of the steepest ascent, diagonals being
/// longer; pixels of a plateau go to the nearest way up; each plateau without one has one peak.
class Ascent {
 public:
  /// Ways of a pixel besides the numbers of its neighbours in kNeighbours.
  enum Way : std::uint8_t { kPeak = 8, kFlat = 9, kOutside = 10 };

  /// @param relief  row-major without gaps, 0 = not part of it
  explicit Ascent(const cv::Mat1f& relief);

  /// A number of kNeighbours, or kPeak, or kOutside where the relief is 0.
  std::uint8_t way(std::size_t index) const { return up_[index]; }
  /// The pixel that a pixel's way leads to, which must not be kPeak or kOutside.
  std::size_t next(std::size_t index) const {
    return index + static_cast<std::size_t>(offsets_[up_[index]]);
  }

  /// Calls f(neighbour's number, its index) for each neighbour of a pixel inside the relief's
  /// image.
  template <typename F>
  void forEachNeighbour(std::size_t index, F f) const {
    const auto columns = static_cast<std::size_t>(columns_);
    const Pixel p{static_cast<int>(index % columns), static_cast<int>(index / columns)};
    for (std::uint8_t n = 0; n < kNeighbours.size(); ++n) {
      const Pixel q = p + kNeighbours[n];
      if (q.x < 0 || q.y < 0 || q.x >= columns_ || q.y >= rows_) continue;
      f(n, index + static_cast<std::size_t>(offsets_[n]));
    }
  }

 private:
  std::vector<std::size_t> takeSteepest(const cv::Mat1f& relief);
  void crossPlateaus(const float* height, const std::vector<std::size_t>& flat);
  bool followEqual(const float* height, std::size_t i);
  void spread(const float* height, std::vector<std::size_t>& queue);

  int columns_;
  int rows_;
  std::array<std::ptrdiff_t, 8> offsets_{};  ///< from a pixel's index to its neighbours'
  std::vector<std::uint8_t> up_;
};

}  // namespace agrid

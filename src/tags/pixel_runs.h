// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace agrid {

/// Pixels of one row that follow each other and have the same value.
struct PixelRun {
  int y = 0;
  int begin = 0;
  int end = 0;  ///< one past the last
};

/// All runs of `value` in an image of 0 and 1, row by row from the left.
std::vector<PixelRun> findRuns(const cv::Mat1b& image, std::uint8_t value);

/// For each run the number of its connected component. Components are counted from 0 in the order
/// of their first runs.
/// @param runs  as findRuns returns them
/// @param by_corners  whether pixels that touch by a corner only hang together (8-connected)
std::vector<std::uint32_t> connectRuns(const std::vector<PixelRun>& runs, bool by_corners);

/// Calls f(begin, end, value) for each run of equal values of a row, from the left.
template <typename T, typename F>
void forEachRun(const T* row, int columns, F f) {
  for (int begin = 0, end = 0; begin < columns; begin = end) {
    while (end < columns && row[end] == row[begin]) ++end;
    f(begin, end, row[begin]);
  }
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tags/free_space.h"
#include "tags/sight.h"

namespace agrid::test {

/// Free space that can be looked through.
struct MeasuredSpace {
  MeasuredSpace(const cv::Mat1b& free_space, double resolution)
      : space(free_space.clone()),
        height(distanceFromWalls(space)),
        sight(space, height, resolution) {}
  MeasuredSpace(const MeasuredSpace&) = delete;
  MeasuredSpace& operator=(const MeasuredSpace&) = delete;

  cv::Mat1b space;
  cv::Mat1f height;
  Sight sight;
};

}  // namespace agrid::test

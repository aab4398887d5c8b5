// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "tags/border_profile.h"
#include "tags/borders.h"
#include "tags/free_space.h"
#include "tags/region_graph.h"

namespace agrid::test {

/// Free space divided into regions by hand, with what is needed to look at their borders.
class Regions {
 public:
  /// @param region_at  the region of a point of the image frame [px]
  /// @param openings  lie on the free pixels whose centre is within a pixel of their jambs' line
  template <typename RegionAt>
  Regions(const cv::Mat1b& free_space, double resolution, RegionAt region_at,
          std::vector<Opening> openings = {})
      : geometry{free_space.cols, free_space.rows, resolution, Pose2{}} {
    relief.free_space = free_space;
    relief.height = distanceFromWalls(free_space);
    this->openings.all = std::move(openings);
    for (std::size_t i = 0; i < geometry.pixelCount(); ++i) {
      const Pixel p = geometry.pixel(i);
      const Point2 centre(p.x + 0.5, p.y + 0.5);
      const bool is_free = free_space(p.y, p.x) != 0;
      labels.push_back(is_free ? static_cast<std::uint32_t>(region_at(centre)) : Basins::kNone);
      if (!is_free) continue;
      count = std::max<std::size_t>(count, labels.back() + 1);
      findOpeningAt(i, centre);
    }
    stretches = splitIntoStretches(findBorderPoints(labels, geometry), geometry);
  }
  Regions(const Regions&) = delete;
  Regions& operator=(const Regions&) = delete;

  BorderSurvey survey() const { return {relief, openings, geometry}; }
  RegionGraph graph() const { return {labels, count, stretches, survey()}; }
  BorderProfile profile(std::size_t stretch) const {
    return survey().profileOf(stretches.at(stretch), labels);
  }

  MapGeometry geometry;
  Relief relief;
  Openings openings;
  std::vector<std::uint32_t> labels;
  std::size_t count = 0;
  std::vector<Stretch> stretches;

 private:
  void findOpeningAt(std::size_t pixel, const Point2& centre) {
    for (std::uint32_t k = 0; k < openings.all.size(); ++k) {
      const Segment& jambs = openings.all[k].jambs;
      const Point2 way = (jambs.b - jambs.a).normalized();
      const Point2 offset = centre - jambs.a;
      const double along = offset.dot(way);
      const double aside = offset.x() * way.y() - offset.y() * way.x();
      if (along > 0 && along < jambs.length() && std::abs(aside) <= 1) {
        openings.at_pixel.emplace(pixel, k);
      }
    }
  }
};

}  // namespace agrid::test

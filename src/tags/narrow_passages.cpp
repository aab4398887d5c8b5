// SPDX-License-Identifier: BSD-3-Clause
#include "tags/narrow_passages.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tags/basins.h"
#include "tags/narrowing.h"

namespace agrid {
namespace {

bool isRegular(const Segment& passage, double max_skew_deg) {
  const Point2 way = (passage.b - passage.a).cwiseAbs();
  const double skew = std::atan2(way.minCoeff(), way.maxCoeff());
  return skew * 180 / M_PI <= max_skew_deg;
}

/// Pixels that are not free within `reach` of a jamb.
int pointsAround(const Point2& jamb, double reach, const cv::Mat1b& free_space) {
  int count = 0;
  for (int y = static_cast<int>(jamb.y() - reach); y <= jamb.y() + reach; ++y) {
    for (int x = static_cast<int>(jamb.x() - reach); x <= jamb.x() + reach; ++x) {
      if (x < 0 || y < 0 || x >= free_space.cols || y >= free_space.rows) continue;
      if (std::hypot(x + 0.5 - jamb.x(), y + 0.5 - jamb.y()) > reach) continue;
      if (free_space(y, x) == 0) ++count;
    }
  }
  return count;
}

/// Takes the narrowest first and none that is closer than `spacing` to one taken.
std::vector<Segment> spaceOut(std::vector<Segment> passages, double spacing) {
  std::stable_sort(passages.begin(), passages.end(),
                   [](const Segment& a, const Segment& b) { return a.length() < b.length(); });
  std::map<std::pair<long, long>, std::vector<Point2>> taken;  // by square of the spacing
  std::vector<Segment> spaced;
  for (const Segment& passage : passages) {
    const Point2 middle = passage.midpoint();
    const auto column = std::lround(std::floor(middle.x() / spacing));
    const auto row = std::lround(std::floor(middle.y() / spacing));
    bool is_close = false;
    for (long y = row - 1; y <= row + 1; ++y) {
      for (long x = column - 1; x <= column + 1; ++x) {
        for (const Point2& other : taken[{x, y}]) {
          is_close = is_close || (other - middle).norm() < spacing;
        }
      }
    }
    if (is_close) continue;
    taken[{column, row}].push_back(middle);
    spaced.push_back(passage);
  }
  return spaced;
}

}  // namespace

std::vector<Segment> findNarrowPassages(const Relief& relief, const MapGeometry& geometry,
                                        const AreaParams& params) {
  const PassageParams& limits = params.passages;
  const double pixel = geometry.resolution;
  const double reach_px = limits.support_reach / pixel;
  const Basins basins = findBasins(relief.height);
  std::vector<Segment> passages;
  for (const Saddle& saddle : basins.saddles) {
    const double peak = std::min(basins.basins[saddle.a].height, basins.basins[saddle.b].height);
    if ((peak - static_cast<double>(saddle.height)) * pixel < params.min_prominence) continue;
    const Segment passage = findNarrowing(geometry.pixel(saddle.pixel), relief.height);
    const double width = passage.length() * pixel;
    if (width < limits.min_width || width > limits.max_width) continue;
    if (!isRegular(passage, limits.max_skew_deg)) continue;
    const int points = std::min(pointsAround(passage.a, reach_px, relief.free_space),
                                pointsAround(passage.b, reach_px, relief.free_space));
    if (points * pixel >= limits.min_support) passages.push_back(passage);
  }
  // a spacing of less than a pixel selects nothing
  return spaceOut(std::move(passages), std::max(limits.min_spacing / pixel, 1.));
}

}  // namespace agrid

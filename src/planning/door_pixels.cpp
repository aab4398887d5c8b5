// SPDX-License-Identifier: BSD-3-Clause
#include "planning/door_pixels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planning/fine_point.h"
#include "planning/pixel_walk.h"

namespace agrid::planning {
namespace {

constexpr int kJambReachPx = 3;

/// The part of a segment that lies within the map; none if it lies outside or is not finite.
std::optional<Segment> clipped(const MapGeometry& geometry, const Point2& a, const Point2& b) {
  const Point2 low(-0.5, -0.5);
  const Point2 high(geometry.width - 0.5, geometry.height - 0.5);
  double from = 0;
  double to = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = b[axis] - a[axis];
    if (!std::isfinite(step)) return std::nullopt;
    if (step == 0) {
      if (a[axis] < low[axis] || a[axis] > high[axis]) return std::nullopt;
      continue;
    }
    const double t0 = (low[axis] - a[axis]) / step;
    const double t1 = (high[axis] - a[axis]) / step;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  }
  if (from > to) return std::nullopt;
  return Segment{a + from * (b - a), a + to * (b - a)};
}

}  // namespace

std::vector<std::size_t> doorPixels(const MapGeometry& geometry, const Segment& jambs_map,
                                    const std::function<bool(std::size_t)>& isOpen) {
  std::vector<std::size_t> pixels;
  const auto jambs = clipped(geometry, pixelCoordinates(geometry, jambs_map.a),
                             pixelCoordinates(geometry, jambs_map.b));
  if (!jambs) return pixels;
  const Point2 a = jambs->a;
  const Point2 b = jambs->b;
  const auto blockPixel = [&](Pixel p) {
    if (geometry.contains(p)) pixels.push_back(geometry.index(p));
    return true;
  };
  const auto isOpenAt = [&](const Point2& p) {
    const Pixel pixel{static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
    return geometry.contains(pixel) && isOpen(geometry.index(pixel));
  };
  const double length = (b - a).norm();
  const Point2 step = length > 0 ? Point2((b - a) / length) : Point2(Point2::Zero());
  const auto reach = [&](Point2 end, const Point2& outwards) {
    for (int i = 0; i < kJambReachPx && isOpenAt(end); ++i) end += outwards;
    return end;
  };
  const auto inside = clipped(geometry, reach(a, -step), reach(b, step));
  if (inside) walkTouched(finePoint(inside->a), finePoint(inside->b), blockPixel);
  return pixels;
}

}  // namespace agrid::planning

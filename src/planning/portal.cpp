// SPDX-License-Identifier: BSD-3-Clause
#include "planning/portal.h"

#include <algorithm>
#include <cmath>

namespace agrid::planning {
namespace {

double gap(double low_a, double high_a, double low_b, double high_b) {
  return std::max({0.0, low_b - high_a, low_a - high_b});
}

}  // namespace

bool Portal::canLeadTo(FinePoint p, std::uint32_t node) const {
  if (!straight) return true;
  const bool upright = border.low.x == border.high.x;
  const std::int64_t across = upright ? p.x - crossing().x : p.y - crossing().y;
  return sideOf(node) == 0 ? across <= 0 : across >= 0;
}

bool Portal::canLeadToBorder(const Portal& other, std::uint32_t node) const {
  return canLeadTo(lowerCornerOf(other.border.low), node) ||
         canLeadTo(lowerCornerOf(other.border.high), node);
}

double Portal::distanceToBorder(FinePoint p) const {
  const Point2 from = coordinates(p) + Point2(0.5, 0.5);
  return std::hypot(gap(border.low.x, border.high.x, from.x(), from.x()),
                    gap(border.low.y, border.high.y, from.y(), from.y()));
}

double Portal::distanceToBorder(const Portal& other) const {
  return std::hypot(gap(border.low.x, border.high.x, other.border.low.x, other.border.high.x),
                    gap(border.low.y, border.high.y, other.border.low.y, other.border.high.y));
}

PixelBox widened(const PixelBox& box, int px) {
  return {{box.low.x - px, box.low.y - px}, {box.high.x + px, box.high.y + px}};
}

PixelBox clippedTo(const MapGeometry& geometry, const PixelBox& box) {
  return common(box, {{0, 0}, {geometry.width - 1, geometry.height - 1}});
}

PixelBox merged(const PixelBox& a, const PixelBox& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

PixelBox common(const PixelBox& a, const PixelBox& b) {
  if (!overlap(a, b)) return {};
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

void PixelBox::add(Pixel p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

}  // namespace agrid::planning

// SPDX-License-Identifier: BSD-3-Clause
#include "planning/turning_point.h"

#include <cstddef>

namespace agrid::planning {
namespace {

/// Between the pixels (x, y) and (x + 1, y + 1), of which `blocked` is not free.
TurningPoint besideCorner(int x, int y, Pixel blocked) {
  TurningPoint point;
  point.blocked_x = blocked.x == x ? -1 : 1;
  point.blocked_y = blocked.y == y ? -1 : 1;
  point.at = {x * kFine + kFine / 2 - point.blocked_x, y * kFine + kFine / 2 - point.blocked_y};
  return point;
}

/// From pixel `first` on.
void freeOfRow(const FreeSpace& free, Pixel first, std::vector<std::uint8_t>& row) {
  for (std::uint8_t& is_free : row) {
    is_free = free.isFree(first) ? 1 : 0;
    ++first.x;
  }
}

}  // namespace

std::vector<TurningPoint> turningPoints(const FreeSpace& free, const StopCheck& stop) {
  const MapGeometry& geometry = free.geometry();
  return turningPoints(free, {{0, 0}, {geometry.width - 1, geometry.height - 1}}, stop);
}

std::vector<TurningPoint> turningPoints(const FreeSpace& free, const PixelBox& box,
                                        const StopCheck& stop) {
  const PixelBox around = clippedTo(free.geometry(), widened(box, 1));
  std::vector<TurningPoint> points;
  std::vector<std::uint8_t> low(around.columns());
  std::vector<std::uint8_t> high(low.size());
  freeOfRow(free, around.low, high);
  for (int y = around.low.y; y < around.high.y; ++y) {
    if (y % 64 == 0) stop.check();
    std::swap(low, high);
    freeOfRow(free, {around.low.x, y + 1}, high);
    for (std::size_t i = 0; i + 1 < low.size(); ++i) {
      if (low[i] + low[i + 1] + high[i] + high[i + 1] != 3) continue;
      const int x = around.low.x + static_cast<int>(i);
      const int blocked_x = low[i] != 0 && high[i] != 0 ? x + 1 : x;
      const int blocked_y = low[i] != 0 && low[i + 1] != 0 ? y + 1 : y;
      const TurningPoint point = besideCorner(x, y, {blocked_x, blocked_y});
      if (holds(box, point.at.pixel())) points.push_back(point);
    }
  }
  return points;
}

}  // namespace agrid::planning

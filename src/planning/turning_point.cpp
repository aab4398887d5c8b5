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

void freeOfRow(const FreeSpace& free, int y, std::vector<std::uint8_t>& row) {
  for (int x = 0; x < free.geometry().width; ++x) {
    row[static_cast<std::size_t>(x)] = free.isFree({x, y}) ? 1 : 0;
  }
}

}  // namespace

std::vector<TurningPoint> turningPoints(const FreeSpace& free, const StopCheck& stop) {
  const MapGeometry& geometry = free.geometry();
  std::vector<TurningPoint> points;
  std::vector<std::uint8_t> low(static_cast<std::size_t>(geometry.width));
  std::vector<std::uint8_t> high(low.size());
  for (int y = 0; y + 1 < geometry.height; ++y) {
    if (y % 64 == 0) stop.check();
    std::swap(low, high);
    freeOfRow(free, y + 1, high);
    for (int x = 0; x + 1 < geometry.width; ++x) {
      const auto i = static_cast<std::size_t>(x);
      if (low[i] + low[i + 1] + high[i] + high[i + 1] != 3) continue;
      const int blocked_x = low[i] != 0 && high[i] != 0 ? x + 1 : x;
      const int blocked_y = low[i] != 0 && low[i + 1] != 0 ? y + 1 : y;
      points.push_back(besideCorner(x, y, {blocked_x, blocked_y}));
    }
  }
  return points;
}

}  // namespace agrid::planning

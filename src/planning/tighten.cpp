// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tighten.h"

#include <algorithm>
#include <array>
#include <utility>

namespace agrid::planning {
namespace {

constexpr int kMaxRounds = 20;
/// Corners move by steps from this one ...
constexpr std::int64_t kFirstStep = 2 * kFine;
/// ... down to this one.
constexpr std::int64_t kLastStep = kFine / 16;

/// Leaves out every corner that can be left out, farthest sight first.
bool removeCorners(const FreeSpace& free, std::vector<FinePoint>& path) {
  std::vector<FinePoint> kept{path.front()};
  for (std::size_t i = 0; i + 1 < path.size();) {
    std::size_t next = i + 1;
    // Sight comes and goes along a path around corners; a few corners ahead suffice.
    for (std::size_t j = std::min(path.size() - 1, i + 8); j > i + 1; --j) {
      if (!free.canSee(path[i], path[j])) continue;
      next = j;
      break;
    }
    kept.push_back(path[next]);
    i = next;
  }
  const bool changed = kept.size() < path.size();
  path = std::move(kept);
  return changed;
}

/// Moves one corner as far as it shortens the path.
bool moveCorner(const FreeSpace& free, FinePoint before, FinePoint& corner, FinePoint after) {
  bool changed = false;
  double length = distancePx(before, corner) + distancePx(corner, after);
  for (std::int64_t step = kFirstStep; step >= kLastStep; step /= 2) {
    const std::array<FinePoint, 8> moves{{{step, 0},
                                          {-step, 0},
                                          {0, step},
                                          {0, -step},
                                          {step, step},
                                          {step, -step},
                                          {-step, step},
                                          {-step, -step}}};
    for (bool moved = true; moved;) {
      moved = false;
      for (const FinePoint& move : moves) {
        const FinePoint there{corner.x + move.x, corner.y + move.y};
        const double new_length = distancePx(before, there) + distancePx(there, after);
        if (new_length > length - 1e-6) continue;
        if (!free.canSee(before, there) || !free.canSee(there, after)) continue;
        corner = there;
        length = new_length;
        moved = changed = true;
      }
    }
  }
  return changed;
}

}  // namespace

double lengthPx(const std::vector<FinePoint>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += distancePx(path[i - 1], path[i]);
  return length;
}

void tighten(const FreeSpace& free, std::vector<FinePoint>& path) {
  for (int round = 0; round < kMaxRounds && path.size() > 2; ++round) {
    bool changed = removeCorners(free, path);
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      changed |= moveCorner(free, path[i - 1], path[i], path[i + 1]);
    }
    if (!changed) return;
  }
}

}  // namespace agrid::planning

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "planning/plan_oracle.h"

namespace agrid::test {

/// The length that paths through free pixels come as near to as one likes, and that none falls
/// below: the shortest way over the corners of what is not free, by Dijkstra over all that see each
/// other past the open squares of it. Points are in half pixels, pixel centres odd, corners even.
class BestLength {
 public:
  BestLength(const SlowFreeSpace& free, const MapGeometry& geometry)
      : BestLength([&free](Pixel p) { return free.isFree(p); }, geometry) {}
  BestLength(std::function<bool(Pixel)> is_free, const MapGeometry& geometry)
      : is_free_(std::move(is_free)) {
    for (int y = 2; y < 2 * geometry.height; y += 2) {
      for (int x = 2; x < 2 * geometry.width; x += 2) {
        if (freeAround({x, y}) == 3) corners_.push_back({x, y});
      }
    }
  }

  /// To the nearest centre of some free pixels, in pixels; infinite if there is no way.
  double toNearest(Pixel start, const std::vector<Pixel>& goals) const {
    std::vector<Pixel> centers;
    for (const Pixel goal : goals) centers.push_back(centerOf(goal));
    return toNearestPoint(centerOf(start), centers);
  }

  /// As toNearest, between points in half pixels.
  double toNearestPoint(Pixel start, const std::vector<Pixel>& goals) const {
    std::vector<Pixel> places = corners_;
    places.insert(places.end(), goals.begin(), goals.end());
    std::vector<double> lengths(places.size(), std::numeric_limits<double>::infinity());
    std::vector<bool> done(places.size(), false);
    Pixel here = start;
    double length = 0;
    for (;;) {
      std::size_t next = places.size();
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (done[i]) continue;
        const double through = length + std::hypot(here.x - places[i].x, here.y - places[i].y) / 2;
        if (through < lengths[i] && sees(here, places[i])) lengths[i] = through;
        if (next == places.size() || lengths[i] < lengths[next]) next = i;
      }
      if (next == places.size()) return std::numeric_limits<double>::infinity();
      if (next >= corners_.size() || std::isinf(lengths[next])) return lengths[next];
      done[next] = true;
      here = places[next];
      length = lengths[next];
    }
  }

 private:
  static Pixel centerOf(Pixel p) { return {2 * p.x + 1, 2 * p.y + 1}; }

  /// The pixels around a corner, one after the other around it.
  static std::vector<Pixel> around(Pixel corner) {
    const int x = corner.x / 2;
    const int y = corner.y / 2;
    return {{x - 1, y - 1}, {x, y - 1}, {x, y}, {x - 1, y}};
  }
  int freeAround(Pixel corner) const {
    const auto pixels = around(corner);
    return static_cast<int>(
        std::count_if(pixels.begin(), pixels.end(), [&](Pixel p) { return is_free_(p); }));
  }

  /// The free pixels that a point between two crossings of grid lines lies in: of one, or of two
  /// where the segment runs along a line.
  std::vector<Pixel> freeBeside(double x, double y) const {
    std::vector<Pixel> pixels;
    for (const int dx : {0, 1}) {
      for (const int dy : {0, 1}) {
        const bool on_x = std::abs(x / 2 - std::round(x / 2)) < 1e-9;
        const bool on_y = std::abs(y / 2 - std::round(y / 2)) < 1e-9;
        if ((dx == 1 && !on_x) || (dy == 1 && !on_y)) continue;
        const Pixel p{static_cast<int>(on_x ? std::round(x / 2) - dx : std::floor(x / 2)),
                      static_cast<int>(on_y ? std::round(y / 2) - dy : std::floor(y / 2))};
        if (is_free_(p)) pixels.push_back(p);
      }
    }
    return pixels;
  }

  /// Whether one gets from some pixels to others that touch them, by sides of free ones around a
  /// corner where they meet there.
  bool joins(const std::vector<Pixel>& before, const std::vector<Pixel>& after, double x,
             double y) const {
    for (const Pixel a : before) {
      for (const Pixel b : after) {
        const int steps = std::abs(a.x - b.x) + std::abs(a.y - b.y);
        if (steps <= 1) return true;
        const Pixel corner{2 * static_cast<int>(std::round(x / 2)),
                           2 * static_cast<int>(std::round(y / 2))};
        if (steps == 2 && freeAround(corner) >= 3) return true;
      }
    }
    return false;
  }

  bool sees(Pixel a, Pixel b) const {
    std::vector<double> crossings{0, 1};
    const auto cross = [&](int from, int to) {
      for (int line = std::min(from, to) + 1; line < std::max(from, to); ++line) {
        if (line % 2 == 0) crossings.push_back(double(line - from) / (to - from));
      }
    };
    cross(a.x, b.x);
    cross(a.y, b.y);
    std::sort(crossings.begin(), crossings.end());
    std::vector<Pixel> before;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      if (crossings[i + 1] - crossings[i] < 1e-12) continue;
      const auto at = [&](double t) {
        return Point2(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
      };
      const Point2 middle = at((crossings[i] + crossings[i + 1]) / 2);
      const auto here = freeBeside(middle.x(), middle.y());
      const Point2 edge = at(crossings[i]);
      if (here.empty()) return false;
      if (!before.empty() && !joins(before, here, edge.x(), edge.y())) return false;
      before = here;
    }
    return true;
  }

  std::function<bool(Pixel)> is_free_;
  std::vector<Pixel> corners_;
};

}  // namespace agrid::test

// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cost_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/fine_point.h"
#include "planning/pixel_walk.h"

namespace agrid::planning {
namespace {

/// Lines that are tried in place of a way are at most so many of its steps long: longer ones
/// rarely are free, and trying them costs time.
constexpr std::size_t kLongest = 400;

/// Where on a line (0 to 1) the next border between pixels along one axis is crossed.
struct Borders {
  Borders(double from, double to)
      : step(to > from ? 1 : -1), rate(to - from), start(from), next(std::floor(from + 0.5)) {
    next += step > 0 ? 0.5 : -0.5;
  }
  double place() const { return rate == 0 ? 2 : (next - start) / rate; }
  double step;
  double rate;
  double start;
  double next;
};

bool isFree(const CostField& field, const Point2& a, const Point2& b) {
  return walkTouched(finePoint(a), finePoint(b), [&](Pixel p) {
    return field.geometry().contains(p) && !field.isBlocked(field.geometry().index(p));
  });
}

/// Whether the line is free with a margin: points on it, rounded to the lattice, join freely, too.
bool isClear(const CostField& field, const Point2& a, const Point2& b) {
  constexpr double kMargin = 1.0 / 4096;
  const Point2 along = b - a;
  const Point2 aside = Point2(-along.y(), along.x()).normalized() * kMargin;
  return isFree(field, a + aside, b + aside) && isFree(field, a - aside, b - aside);
}

/// The farthest step from `from` to which the straight line costs no more than the way.
std::size_t farthest(const CostField& field, const std::vector<Point2>& way,
                     const std::vector<double>& sums, std::size_t from) {
  const auto isCheap = [&](std::size_t to) {
    return isClear(field, way[from], way[to]) &&
           costOfLine(field, way[from], way[to]) <= (sums[to] - sums[from]) * (1 + 1e-6);
  };
  const std::size_t last = std::min(way.size() - 1, from + kLongest);
  std::size_t good = from + 1;
  std::size_t bad = last + 1;
  for (std::size_t stride = 2; good < last; stride *= 2) {
    const std::size_t to = std::min(from + stride, last);
    if (!isCheap(to)) {
      bad = to;
      break;
    }
    good = to;
  }
  while (bad - good > 1 && bad <= last) {
    const std::size_t middle = good + (bad - good) / 2;
    (isCheap(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace

double costOfLine(const CostField& field, const Point2& a, const Point2& b) {
  if (!isFree(field, a, b)) return std::numeric_limits<double>::infinity();
  const MapGeometry& geometry = field.geometry();
  Borders columns(a.x(), b.x());
  Borders rows(a.y(), b.y());
  double sum = 0;
  for (double here = 0; here < 1;) {
    const double there = std::clamp(std::min(columns.place(), rows.place()), here, 1.0);
    const Point2 middle = a + (here + there) / 2 * (b - a);
    const Pixel p{std::clamp(static_cast<int>(std::lround(middle.x())), 0, geometry.width - 1),
                  std::clamp(static_cast<int>(std::lround(middle.y())), 0, geometry.height - 1)};
    // a border between pixels may round into one that the line does not touch
    const double factor = field.isBlocked(geometry.index(p))
                              ? 1
                              : static_cast<double>(field.factor(geometry.index(p)));
    sum += (there - here) * factor;
    if (there >= 1) break;
    Borders& crossed = columns.place() <= rows.place() ? columns : rows;
    crossed.next += crossed.step;
    here = there;
  }
  return sum * (b - a).norm();
}

std::vector<Point2> pulledStraight(const CostField& field, const std::vector<Point2>& way) {
  if (way.size() < 3) return way;
  std::vector<double> sums{0};
  for (std::size_t i = 1; i < way.size(); ++i) {
    sums.push_back(sums.back() + costOfLine(field, way[i - 1], way[i]));
  }
  std::vector<Point2> straight{way.front()};
  for (std::size_t i = 0; i + 1 < way.size();) {
    i = farthest(field, way, sums, i);
    straight.push_back(way[i]);
  }
  return straight;
}

std::vector<Point2> resampled(const std::vector<Point2>& way, double step) {
  std::vector<Point2> points;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Point2 along = way[i] - way[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(along.norm() / step)));
    for (int k = 0; k < parts; ++k) points.emplace_back(way[i - 1] + along * k / parts);
  }
  if (!way.empty()) points.push_back(way.back());
  return points;
}

}  // namespace agrid::planning

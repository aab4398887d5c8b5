// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdlib>

#include "planning/fine_point.h"

namespace agrid::planning {

/// The columns and rows that a straight segment passes, computed in integers. Seen along its longer
/// axis: "column" and "row" change places for a segment steeper than 45 degrees.
class SegmentRaster {
 public:
  SegmentRaster(FinePoint a, FinePoint b)
      : steep_(std::abs(b.y - a.y) > std::abs(b.x - a.x)), a_(turned(a)), b_(turned(b)) {
    step_ = b_.x < a_.x ? -1 : 1;
    first_ = lower(std::min(a_.x, b_.x));
    last_ = upper(std::max(a_.x, b_.x));
    if (step_ < 0) std::swap(first_, last_);
    dx_ = b_.x - a_.x;
    dy_ = b_.y - a_.y;
    if (dx_ < 0) {
      dx_ = -dx_;
      dy_ = -dy_;
    }
    constexpr auto kStep = static_cast<double>(kFine);
    slope_ = dx_ == 0 ? 0 : static_cast<double>(dy_) / static_cast<double>(dx_);
    y_at_0_ = static_cast<double>(a_.y) / kStep - static_cast<double>(a_.x) / kStep * slope_;
    low_x_ = static_cast<double>(std::min(a_.x, b_.x)) / kStep;
    high_x_ = static_cast<double>(std::max(a_.x, b_.x)) / kStep;
  }

  struct Rows {
    int low = 0;
    int high = 0;
  };

  int first() const { return first_; }
  int last() const { return last_; }
  int step() const { return step_; }
  /// Direction of travel across the rows.
  bool rising() const { return b_.y >= a_.y; }
  Pixel pixel(int column, int row) const {
    return steep_ ? Pixel{row, column} : Pixel{column, row};
  }
  /// Length of the segment per column.
  double stretch() const { return std::sqrt(1 + slope_ * slope_); }

  /// Rows whose closed squares the segment touches in a column.
  Rows touched(int column) const {
    if (dx_ == 0) return {lower(a_.y), upper(a_.y)};
    const double from = std::max(low_x_, column - 0.5);
    const double to = std::min(high_x_, column + 0.5);
    const double y0 = y_at_0_ + from * slope_;
    const double y1 = y_at_0_ + to * slope_;
    const double low = std::min(y0, y1) - 0.5;
    const double high = std::max(y0, y1) + 0.5;
    const auto low_row = static_cast<int>(low);
    const auto high_row = static_cast<int>(high);
    if (isSure(low - low_row) && isSure(high - high_row)) return {low_row + 1, high_row};
    const Extent y = extent(column);
    return {static_cast<int>(ceilDivide(y.low - y.half, 2 * y.half)),
            static_cast<int>(floorDivide(y.high + y.half, 2 * y.half))};
  }

  /// Rows whose squares' insides the segment crosses in a column, but those touched where it runs
  /// along the border of two rows; low > high where it only touches the column.
  Rows crossed(int column) const {
    if (dx_ == 0) return touched(column);
    const Extent y = extent(column);
    if (y.point) return {0, -1};
    const Rows rows{static_cast<int>(floorDivide(y.low - y.half, 2 * y.half) + 1),
                    static_cast<int>(ceilDivide(y.high + y.half, 2 * y.half) - 1)};
    return rows.low <= rows.high ? rows : touched(column);
  }

 private:
  /// Where the segment is in a column: y * dx_, and half a pixel in that unit.
  struct Extent {
    std::int64_t low;
    std::int64_t high;
    std::int64_t half;
    bool point;
  };
  Extent extent(int column) const {
    const std::int64_t x0 = std::max(std::min(a_.x, b_.x), column * kFine - kFine / 2);
    const std::int64_t x1 = std::min(std::max(a_.x, b_.x), column * kFine + kFine / 2);
    const std::int64_t y0 = a_.y * dx_ + (x0 - a_.x) * dy_;
    const std::int64_t y1 = a_.y * dx_ + (x1 - a_.x) * dy_;
    return {std::min(y0, y1), std::max(y0, y1), dx_ * (kFine / 2), x0 == x1};
  }
  /// Whether a coordinate in floating point is certainly on the same side of the border of two rows
  /// as the exact one, by the part of it after the point. Its error is below 1e-9 up to 2^20
  /// pixels.
  static bool isSure(double fraction) { return fraction > 1e-6 && fraction < 1 - 1e-6; }
  static std::int64_t floorDivide(std::int64_t n, std::int64_t d) {
    return n / d - (n % d < 0 ? 1 : 0);
  }
  static std::int64_t ceilDivide(std::int64_t n, std::int64_t d) {
    return n / d + (n % d > 0 ? 1 : 0);
  }
  static int lower(std::int64_t v) { return static_cast<int>(ceilDivide(v - kFine / 2, kFine)); }
  static int upper(std::int64_t v) { return static_cast<int>(floorDivide(v + kFine / 2, kFine)); }
  FinePoint turned(FinePoint p) const { return steep_ ? FinePoint{p.y, p.x} : p; }

  bool steep_;
  FinePoint a_;
  FinePoint b_;
  int step_ = 1;
  int first_ = 0;
  int last_ = 0;
  std::int64_t dx_ = 0;
  std::int64_t dy_ = 0;
  double slope_ = 0;  ///< the same segment in floating point [px]
  double y_at_0_ = 0;
  double low_x_ = 0;
  double high_x_ = 0;
};

/// Visits the pixels whose closed squares a segment touches, column after column along it (the
/// supercover): no gap, and at a corner all four pixels.
/// @param visit  takes a Pixel, returns whether to go on
/// @return whether all were visited
template <typename Visit>
bool walkTouched(FinePoint a, FinePoint b, const Visit& visit) {
  const SegmentRaster raster(a, b);
  for (int c = raster.first();; c += raster.step()) {
    const SegmentRaster::Rows rows = raster.touched(c);
    const int from = raster.rising() ? rows.low : rows.high;
    const int to = raster.rising() ? rows.high : rows.low;
    for (int r = from;; r += raster.rising() ? 1 : -1) {
      if (!visit(raster.pixel(c, r))) return false;
      if (r == to) break;
    }
    if (c == raster.last()) return true;
  }
}

}  // namespace agrid::planning

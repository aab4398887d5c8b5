// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "agrid/geometry/pose2.h"
#include "agrid/map/occupancy_map.h"

namespace agrid::test {

/// A floor plan of rectangles in metres, x to the right, y up, that can be drawn at any resolution
/// and turned about its middle. What is not opened is wall.
class DrawnPlan {
 public:
  DrawnPlan(double width, double height) : size_(width, height) {}

  /// Later rectangles cover earlier ones.
  DrawnPlan& open(const Point2& low, const Point2& high) { return add(low, high, 1); }
  DrawnPlan& close(const Point2& low, const Point2& high) { return add(low, high, 0); }

  /// Draws from now on at this resolution [m], turned counter-clockwise.
  DrawnPlan& at(double resolution, double turn_deg = 0) {
    resolution_ = resolution;
    turn_ = turn_deg * 3.14159265358979323846 / 180;
    return *this;
  }
  double resolution() const { return resolution_; }

  /// Where a point of the plan [m] lies in the image [px].
  Point2 inImage(const Point2& point) const {
    const Point2 middle_px(columns() / 2., rows() / 2.);
    const Point2 offset = (point - size_ / 2) / resolution_;
    return turn_ == 0 ? Point2(point / resolution_) : Pose2{middle_px, turn_} * offset;
  }

  /// 1 = free, 0 = wall; row 0 has the smallest y.
  cv::Mat1b freeSpace() const {
    cv::Mat1b space(rows(), columns(), std::uint8_t{0});
    const Pose2 image_from_middle{Point2(columns() / 2., rows() / 2.), turn_};
    for (int y = 0; y < space.rows; ++y) {
      for (int x = 0; x < space.cols; ++x) {
        Point2 point = Point2(x + 0.5, y + 0.5) * resolution_;
        if (turn_ != 0) {
          point = inverse(image_from_middle) * Point2(x + 0.5, y + 0.5) * resolution_ + size_ / 2;
        }
        for (const Rectangle& r : rectangles_) {
          const bool is_inside = point.x() > r.low.x() && point.y() > r.low.y() &&
                                 point.x() < r.high.x() && point.y() < r.high.y();
          if (is_inside) space(y, x) = r.value;
        }
      }
    }
    return space;
  }

  OccupancyMap map() const {
    const cv::Mat1b space = freeSpace();
    OccupancyGrid grid;
    grid.geometry = {space.cols, space.rows, resolution_, Pose2{}};
    for (const std::uint8_t pixel : space) {
      grid.values.push_back(static_cast<std::int8_t>(pixel != 0 ? 0 : 100));
    }
    return OccupancyMap(grid);
  }

 private:
  struct Rectangle {
    Point2 low = Point2::Zero();
    Point2 high = Point2::Zero();
    std::uint8_t value = 0;
  };

  DrawnPlan& add(const Point2& low, const Point2& high, std::uint8_t value) {
    rectangles_.push_back({low, high, value});
    return *this;
  }
  int pixels(double length) const { return static_cast<int>(std::lround(length / resolution_)); }
  int columns() const { return pixels(turn_ == 0 ? size_.x() : size_.norm()); }
  int rows() const { return pixels(turn_ == 0 ? size_.y() : size_.norm()); }

  Point2 size_;
  double resolution_ = 0.05;
  double turn_ = 0;  ///< [rad]
  std::vector<Rectangle> rectangles_;
};

}  // namespace agrid::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "agrid/evaluation/office_generator.h"
#include "evaluation/office_plan.h"

namespace agrid {

constexpr std::int8_t kFreeValue = 0;
constexpr std::int8_t kOccupiedValue = 100;
constexpr std::int8_t kUnknownValue = -1;

/// Draws rectangles into an occupancy grid; what lies outside of it is passed over.
class GridCanvas {
 public:
  explicit GridCanvas(OccupancyGrid& grid) : grid_(grid) {}

  bool contains(int x, int y) const { return grid_.geometry.contains({x, y}); }
  std::int8_t at(int x, int y) const { return grid_.values[grid_.geometry.index({x, y})]; }
  void set(int x, int y, std::int8_t value) {
    if (contains(x, y)) grid_.values[grid_.geometry.index({x, y})] = value;
  }
  void fill(const PixelRect& rect, std::int8_t value);
  /// The rectangle's outermost pixels, `thickness` deep.
  void frame(const PixelRect& rect, int thickness, std::int8_t value);

 private:
  OccupancyGrid& grid_;
};

/// Puts tables, chairs, cabinets, pillars and open door leaves into the rooms.
void drawFurniture(const OfficePlan& plan, const OfficeScale& scale, RandomSource& random,
                   GridCanvas& canvas);

/// Makes a clean drawing look as a laser scanner would have seen it.
void drawNoise(const OfficePlan& plan, const OfficeScale& scale, RandomSource& random,
               Office& office);

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/office_plan.h"

#include <algorithm>

#include "evaluation/office_rooms.h"

namespace agrid {
namespace {

constexpr int kLeastBlock = 4000;      // [mm] depth of a block beside a corridor
constexpr int kOneRow = 8000;          // [mm] deepest block with one row of rooms
constexpr int kTwoRows = 13500;        // [mm] deepest block with two rows of rooms
constexpr int kLongestJoined = 30000;  // [mm] longer corridors are closed off by doors

/// Divides blocks by corridors until rooms fit into them.
class Divider {
 public:
  Divider(const OfficeScale& scale, RandomSource& random)
      : scale_(scale), random_(random), rooms_(scale, random) {}

  OfficePlan plan(const PixelRect& building) {
    Block block;
    block.lines = building;
    divide(block);
    OfficePlan plan = rooms_.takePlan();
    plan.building = building;
    return plan;
  }

 private:
  void divide(const Block& block) {
    const int axis = fits(block) ? -1 : corridorAxis(block);
    if (axis < 0) {
      rooms_.fill(block);
      return;
    }
    const int across = 1 - axis;
    const int width = scale_.pixels(random_.between(1700, block.isWhole() ? 3000 : 2600));
    const int space = block.lines.length(across) - width;
    const int least = std::max(scale_.pixels(kLeastBlock), space * 3 / 10);
    const int start = block.lines.lo[across] + random_.between(least, space - least);
    Block corridor = block;
    corridor.lines.lo[across] = start;
    corridor.lines.hi[across] = start + width;
    const int index = addCorridor(corridor, axis);
    Block low = block;
    low.lines.hi[across] = start;
    low.corridors[across][1] = index;
    divide(low);
    Block high = block;
    high.lines.lo[across] = start + width;
    high.corridors[across][0] = index;
    divide(high);
  }

  /// Whether rooms in one or two rows reach a corridor.
  bool fits(const Block& block) {
    const bool roomy = random_.chance(25);  // some blocks stay large, for halls and back rooms
    for (int across = 0; across < 2; ++across) {
      const int sides = (block.corridors[across][0] >= 0) + (block.corridors[across][1] >= 0);
      const int deepest = sides == 2 || roomy ? kTwoRows : kOneRow;
      if (sides > 0 && block.lines.length(across) <= scale_.pixels(deepest)) return true;
    }
    return false;
  }

  /// The axis along which a corridor can run, the longer one if there are two; -1: none.
  int corridorAxis(const Block& block) const {
    const int longer = block.lines.length(0) >= block.lines.length(1) ? 0 : 1;
    for (const int axis : {longer, 1 - longer}) {
      const bool reached = block.corridors[axis][0] >= 0 || block.corridors[axis][1] >= 0;
      const int needed = scale_.pixels(2 * kLeastBlock + 3000);
      if ((reached || block.isWhole()) && block.lines.length(1 - axis) > needed) return axis;
    }
    return -1;
  }

  int addCorridor(const Block& corridor, int axis) {
    const int index = rooms_.addRoom(corridor.lines, RoomKind::kCorridor);
    const bool join = corridor.lines.length(axis) < scale_.pixels(kLongestJoined);
    bool reached = false;
    for (int end = 0; end < 2; ++end) {
      const int other = corridor.corridors[axis][end];
      if (other < 0 || (reached && random_.chance(25))) continue;
      const int line = end == 0 ? corridor.lines.lo[axis] : corridor.lines.hi[axis];
      if (join && random_.chance(55)) {
        rooms_.addJunction(index, other, {axis, line});
      } else {
        rooms_.addDoor({index, other, axis, line, DoorSize::kDouble});
      }
      reached = true;
    }
    return index;
  }

  OfficeScale scale_;
  RandomSource& random_;
  RoomPlanner rooms_;
};

}  // namespace

OfficePlan planOffice(int size, const OfficeScale& scale, RandomSource& random) {
  const int margin = std::clamp(size / 16, scale.pixels(300) + 1, scale.pixels(2500));
  return Divider(scale, random).plan({{margin, margin}, {size - margin, size - margin}});
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/office_rooms.h"

#include <algorithm>
#include <utility>

namespace agrid {
namespace {

constexpr int kNarrowest = 2300;  // [mm] a room between its wall lines
constexpr int kOneRow = 8000;     // [mm] deeper blocks get two rows

}  // namespace

int RoomPlanner::addRoom(const PixelRect& lines, RoomKind kind) {
  const int wall = scale_.wall();
  PlannedRoom room;
  for (int axis = 0; axis < 2; ++axis) {
    room.inside.lo[axis] = lines.lo[axis] - wall / 2 + wall;
    room.inside.hi[axis] = lines.hi[axis] - wall / 2;
  }
  room.kind = kind;
  plan_.rooms.push_back(std::move(room));
  merged_into_.push_back(static_cast<int>(merged_into_.size()));
  return static_cast<int>(plan_.rooms.size()) - 1;
}

std::array<int, 2> RoomPlanner::sharedRange(int room, int other, int axis) const {
  const PixelRect& a = plan_.rooms[static_cast<std::size_t>(room)].inside;
  const PixelRect& b = plan_.rooms[static_cast<std::size_t>(other)].inside;
  return {std::max(a.lo[axis], b.lo[axis]), std::min(a.hi[axis], b.hi[axis])};
}

int RoomPlanner::addDoor(const DoorOrder& order) {
  const int along = 1 - order.axis;
  const auto [low, high] = sharedRange(order.room, order.beyond, along);
  const int clear = std::max(1, scale_.pixels(150));
  int width = order.size == DoorSize::kDouble ? scale_.pixels(random_.between(1300, 1800))
                                              : scale_.pixels(random_.between(800, 1000));
  width = std::min(width, high - low - 2 * clear);
  if (width < scale_.pixels(700)) return -1;
  // Doors sit near a corner more often than in the middle.
  const int slack = high - low - 2 * clear - width;
  const int shift = std::min(slack, scale_.pixels(random_.between(0, 400)));
  const int anywhere = random_.between(0, slack);
  const int habit = random_.between(0, 2);
  const int start = low + clear + (habit == 0 ? shift : habit == 1 ? slack - shift : anywhere);
  const int wall = scale_.wall();
  const int wall_start = order.line - wall / 2;
  Doorway door;
  door.axis = order.axis;
  door.opening = rectAlong(order.axis, {wall_start, wall_start + wall}, {start, start + width});
  door.into_hi =
      plan_.rooms[static_cast<std::size_t>(order.room)].inside.lo[order.axis] >= wall_start;
  const std::size_t index = plan_.doorways.size();
  plan_.doorways.push_back(door);
  for (const int room : {order.room, order.beyond}) {
    plan_.rooms[static_cast<std::size_t>(room)].doorways.push_back(index);
  }
  return static_cast<int>(index);
}

void RoomPlanner::addJunction(int corridor, int other, WallPlace place) {
  const int start = place.line - scale_.wall() / 2;
  const auto range = sharedRange(corridor, other, 1 - place.axis);
  for (const int room : {corridor, other}) {
    plan_.rooms[static_cast<std::size_t>(room)].junctions.push_back(plan_.junctions.size());
  }
  plan_.junctions.push_back({rectAlong(place.axis, {start, start + scale_.wall()}, range),
                             place.axis, static_cast<std::size_t>(corridor)});
  merged_into_[static_cast<std::size_t>(root(corridor))] = root(other);
}

int RoomPlanner::root(int room) const {
  while (merged_into_[static_cast<std::size_t>(room)] != room) {
    room = merged_into_[static_cast<std::size_t>(room)];
  }
  return room;
}

std::vector<int> RoomPlanner::cutLines(int from, int to) {
  const bool modular = random_.chance(50);  // many buildings repeat one width
  const int module = random_.between(2600, 5200);
  std::vector<int> lines{from};
  while (true) {
    const int drawn = random_.between(2600, 6500);
    const int width = scale_.pixels(modular ? module : drawn);
    if (to - lines.back() < width + scale_.pixels(kNarrowest)) break;
    lines.push_back(lines.back() + width);
  }
  lines.push_back(to);
  return lines;
}

std::vector<int> RoomPlanner::addRow(const Row& row) {
  const std::vector<int> cuts = cutLines(row.lines.lo[row.axis], row.lines.hi[row.axis]);
  std::vector<int> rooms;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    PixelRect lines = row.lines;
    lines.lo[row.axis] = cuts[i];
    lines.hi[row.axis] = cuts[i + 1];
    const bool large = lines.shorter() > scale_.pixels(4500);
    const bool meeting = random_.chance(large ? 60 : 10);
    const bool locked = random_.chance(3) && !row.all_used;
    rooms.push_back(locked ? -1 : addRoom(lines, meeting ? RoomKind::kMeeting : RoomKind::kOffice));
  }
  return rooms;
}

void RoomPlanner::connectRow(const Row& row, const std::vector<int>& rooms) {
  bool former_open = false;  // whether the former room has an open door to the corridor
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (rooms[i] < 0) {
      former_open = false;
      continue;
    }
    const int door =
        row.corridor < 0
            ? -1
            : addDoor({rooms[i], row.corridor, 1 - row.axis, row.front, DoorSize::kSingle});
    const bool wanted = random_.chance(14) || row.corridor < 0;
    const bool shut = random_.chance(40);
    const bool linked = wanted && i > 0 && rooms[i - 1] >= 0;
    const int wall = plan_.rooms[static_cast<std::size_t>(rooms[i])].inside.lo[row.axis] -
                     scale_.wall() + scale_.wall() / 2;
    const int link =
        linked ? addDoor({rooms[i], rooms[i - 1], row.axis, wall, DoorSize::kSingle}) : -1;
    // Only a room that can be entered through its neighbour may be shut off from the corridor.
    const bool close = door >= 0 && link >= 0 && former_open && shut;
    if (close) plan_.doorways[static_cast<std::size_t>(door)].shut = true;
    former_open = door >= 0 && !close;
  }
}

std::vector<int> RoomPlanner::addBackRow(const Row& row, const std::vector<int>& front) {
  const std::vector<int> rooms = addRow(row);
  for (const int room : rooms) {
    const auto overlap = [&](int other) {
      const auto [low, high] = sharedRange(room, other, row.axis);
      return high - low;
    };
    const int widest = *std::max_element(front.begin(), front.end(),
                                         [&](int a, int b) { return overlap(a) < overlap(b); });
    addDoor({room, widest, 1 - row.axis, row.front, DoorSize::kSingle});
  }
  return rooms;
}

void RoomPlanner::addHall(const Block& block) {
  const int hall = addRoom(block.lines, RoomKind::kHall);
  for (int axis = 0; axis < 2; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const int corridor = block.corridors[axis][side];
      if (corridor < 0) continue;
      const int line = side == 0 ? block.lines.lo[axis] : block.lines.hi[axis];
      addDoor({hall, corridor, axis, line, DoorSize::kDouble});
    }
  }
}

void RoomPlanner::fillFrom(const Block& block, int across, int side) {
  const int depth = block.lines.length(across);
  const int rows = std::max(1, (depth + scale_.pixels(kOneRow) - 1) / scale_.pixels(kOneRow));
  std::vector<int> front;
  for (int i = 0; i < rows; ++i) {
    const int near = depth * i / rows;
    const int far = depth * (i + 1) / rows;
    Row row;
    row.axis = 1 - across;
    row.lines = block.lines;
    row.lines.lo[across] = side == 0 ? block.lines.lo[across] + near : block.lines.hi[across] - far;
    row.lines.hi[across] = side == 0 ? block.lines.lo[across] + far : block.lines.hi[across] - near;
    row.front = side == 0 ? row.lines.lo[across] : row.lines.hi[across];
    row.corridor = block.corridors[across][side];
    row.all_used = rows > 1 || row.corridor < 0;
    if (i == 0) {
      front = addRow(row);
      connectRow(row, front);
    } else {
      front = addBackRow(row, front);
    }
  }
}

void RoomPlanner::fill(const Block& block) {
  const int shorter = block.lines.length(0) <= block.lines.length(1) ? 0 : 1;
  const int least = block.lines.length(shorter);
  const bool hall = random_.chance(22) && least > scale_.pixels(6000) &&
                    block.lines.length(1 - shorter) < scale_.pixels(24000);
  const bool courtyard = random_.chance(4) && plan_.rooms.size() > 12;
  if (block.isWhole()) return fillFrom(block, shorter, 0);
  if (hall) return addHall(block);
  if (courtyard) return;
  const auto sides = [&](int axis) {
    return (block.corridors[axis][0] >= 0) + (block.corridors[axis][1] >= 0);
  };
  const int across = sides(shorter) > 0 ? shorter : 1 - shorter;
  const bool high_side = block.corridors[across][0] < 0;
  if (sides(across) < 2 || block.lines.length(across) <= scale_.pixels(kOneRow)) {
    return fillFrom(block, across, high_side ? 1 : 0);
  }
  const int depth = block.lines.length(across);
  const int middle = block.lines.lo[across] + depth * random_.between(40, 60) / 100;
  Block low = block;
  low.lines.hi[across] = middle;
  fillFrom(low, across, 0);
  Block high = block;
  high.lines.lo[across] = middle;
  fillFrom(high, across, 1);
}

OfficePlan RoomPlanner::takePlan() {
  std::uint16_t label = 0;
  for (std::size_t i = 0; i < plan_.rooms.size(); ++i) {
    if (root(static_cast<int>(i)) == static_cast<int>(i)) plan_.rooms[i].label = ++label;
  }
  for (std::size_t i = 0; i < plan_.rooms.size(); ++i) {
    plan_.rooms[i].label = plan_.rooms[static_cast<std::size_t>(root(static_cast<int>(i)))].label;
  }
  return std::move(plan_);
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "evaluation/office_drawing.h"

namespace agrid {
namespace {

constexpr int kDoorZone = 1100;   // [mm] kept clear on both sides of a doorway
constexpr int kWayBetween = 750;  // [mm] kept clear between two pieces

/// Furnishes one room after another; what it draws never blocks a way.
class Furnisher {
 public:
  Furnisher(const OfficePlan& plan, const OfficeScale& scale, RandomSource& random,
            GridCanvas& canvas)
      : plan_(plan), scale_(scale), random_(random), canvas_(canvas) {}

  void furnish(const PlannedRoom& room) {
    taken_.clear();
    pieces_.clear();
    for (const std::size_t index : room.doorways) {
      const Doorway& door = plan_.doorways[index];
      keepClear(door.opening, door.axis);
      const bool leaf = random_.chance(40);
      if (leaf && !door.shut && room.kind == RoomKind::kOffice) drawLeaf(door, room);
    }
    for (const std::size_t index : room.junctions) {
      keepClear(plan_.junctions[index].opening, plan_.junctions[index].axis);
    }
    if (room.kind == RoomKind::kCorridor) return furnishCorridor(room);
    if (room.kind == RoomKind::kHall) {
      drawPillars(room);
      drawIslands(room);
    }
    if (room.kind == RoomKind::kMeeting) drawMeetingTable(room);
    furnishWalls(room);
  }

 private:
  int leg() const { return std::max(1, scale_.pixels(60)); }

  void keepClear(PixelRect opening, int axis) {
    opening.lo[axis] -= scale_.pixels(kDoorZone);
    opening.hi[axis] += scale_.pixels(kDoorZone);
    taken_.push_back(opening);
  }

  /// Reserves the place if nothing stands too close.
  bool take(const PixelRect& box) {
    const PixelRect wide = box.grown(scale_.pixels(kWayBetween));
    // Zones before doors are clear already; only the piece itself must stay out of them.
    for (const PixelRect& other : taken_) {
      if (other.overlaps(box)) return false;
    }
    for (const PixelRect& piece : pieces_) {
      if (piece.overlaps(wide)) return false;
    }
    pieces_.push_back(box);
    return true;
  }

  /// An open door stands square to its wall, in the room that it opens into.
  void drawLeaf(const Doorway& door, const PlannedRoom& room) {
    const int along = 1 - door.axis;
    const bool inside_hi = room.inside.lo[door.axis] >= door.opening.lo[door.axis];
    const bool at_hi = random_.chance(50);
    if (inside_hi != door.into_hi) return;
    const int width = door.opening.length(along) - 1;
    const int hinge = at_hi ? door.opening.hi[along] : door.opening.lo[along] - 1;
    const int start =
        door.into_hi ? door.opening.hi[door.axis] : door.opening.lo[door.axis] - width;
    canvas_.fill(rectAlong(along, {hinge, hinge + 1}, {start, start + width}), kOccupiedValue);
  }

  void furnishCorridor(const PlannedRoom& room) {
    if (room.inside.shorter() < scale_.pixels(1900)) return;
    const int longer = room.inside.length(0) > room.inside.length(1) ? 0 : 1;
    const int tries = room.inside.length(longer) / scale_.pixels(6000);
    for (int i = 0; i < tries; ++i) {
      const int length = scale_.pixels(random_.between(500, 1600));
      const int depth = scale_.pixels(random_.between(300, 400));
      const bool at_hi = random_.chance(50);
      const int at = random_.between(0, room.inside.length(longer) - length);
      drawCabinet(room, longer, at_hi, {at, at + length, depth});
    }
  }

  void furnishWalls(const PlannedRoom& room) {
    const int perimeter = 2 * (room.inside.length(0) + room.inside.length(1));
    const int tries = std::min(60, perimeter / scale_.pixels(2600));
    for (int i = 0; i < tries; ++i) {
      const int along = random_.between(0, 1);
      const bool at_hi = random_.chance(50);
      const bool desk = random_.chance(50);
      const int length = scale_.pixels(random_.between(desk ? 1200 : 800, desk ? 1800 : 2400));
      const int depth = scale_.pixels(desk ? random_.between(650, 800) : random_.between(380, 600));
      const int at = random_.between(0, room.inside.length(along) - length);
      if (length + 2 > room.inside.length(along)) continue;
      if (3 * depth > room.inside.length(1 - along)) continue;
      if (desk) {
        drawDesk(room, along, at_hi, {at, at + length, depth});
      } else {
        drawCabinet(room, along, at_hi, {at, at + length, depth});
      }
    }
  }

  struct WallPiece {
    int from = 0;
    int to = 0;
    int depth = 0;
  };

  PixelRect besideWall(const PlannedRoom& room, int along, bool at_hi, const WallPiece& p) const {
    const int across = 1 - along;
    const int wall = at_hi ? room.inside.hi[across] - p.depth : room.inside.lo[across];
    return rectAlong(along, {room.inside.lo[along] + p.from, room.inside.lo[along] + p.to},
                     {wall, wall + p.depth});
  }

  void drawCabinet(const PlannedRoom& room, int along, bool at_hi, const WallPiece& piece) {
    const PixelRect box = besideWall(room, along, at_hi, piece);
    if (!take(box)) return;
    // A scanner sees its faces, never what is inside.
    canvas_.fill(box, kUnknownValue);
    canvas_.frame(box, 1, kOccupiedValue);
  }

  void drawDesk(const PlannedRoom& room, int along, bool at_hi, const WallPiece& piece) {
    const PixelRect box = besideWall(room, along, at_hi, piece);
    const bool drawers = random_.chance(60);
    const bool drawers_hi = random_.chance(50);
    if (!take(box)) return;
    drawLegs(box);
    if (drawers) {
      PixelRect unit = box;
      const int width = scale_.pixels(420);
      if (drawers_hi) unit.lo[along] = unit.hi[along] - width;
      if (!drawers_hi) unit.hi[along] = unit.lo[along] + width;
      canvas_.frame(unit, 1, kOccupiedValue);
    }
    const int across = 1 - along;
    const int reach = scale_.pixels(random_.between(150, 450));
    const int seat = at_hi ? box.lo[across] - reach : box.hi[across] + reach;
    std::array<int, 2> chair{};
    chair[along] = (box.lo[along] + box.hi[along]) / 2;
    chair[across] = seat;
    drawChair(chair);
  }

  void drawLegs(const PixelRect& box) {
    for (const int x : {box.lo[0], box.hi[0] - leg()}) {
      for (const int y : {box.lo[1], box.hi[1] - leg()}) {
        canvas_.fill({{x, y}, {x + leg(), y + leg()}}, kOccupiedValue);
      }
    }
  }

  /// Four legs around the centre, or the column of a swivel chair.
  void drawChair(const std::array<int, 2>& center) {
    const PixelRect place =
        PixelRect{center, {center[0] + 1, center[1] + 1}}.grown(scale_.pixels(500));
    const auto overlaps = [&](const PixelRect& other) { return other.overlaps(place); };
    // The last piece is the table that the chair belongs to.
    const bool in_way = std::any_of(taken_.begin(), taken_.end(), overlaps) ||
                        std::any_of(pieces_.begin(), pieces_.end() - 1, overlaps);
    const int half = scale_.pixels(random_.between(190, 230));
    const bool swivel = random_.chance(40);
    if (in_way) return;
    const PixelRect seat =
        PixelRect{center, {center[0] + 1, center[1] + 1}}.grown(swivel ? leg() / 2 : half);
    if (swivel) {
      canvas_.fill(seat, kOccupiedValue);
    } else {
      drawLegs(seat);
    }
  }

  void drawMeetingTable(const PlannedRoom& room) {
    const int longer = room.inside.length(0) > room.inside.length(1) ? 0 : 1;
    const int length = std::min(room.inside.length(longer) - scale_.pixels(2800),
                                scale_.pixels(random_.between(2000, 4800)));
    const int width = scale_.pixels(random_.between(900, 1400));
    if (length < scale_.pixels(1200)) return;
    if (room.inside.length(1 - longer) < width + scale_.pixels(2400)) return;
    const int x = (room.inside.lo[longer] + room.inside.hi[longer] - length) / 2;
    const int y = (room.inside.lo[1 - longer] + room.inside.hi[1 - longer] - width) / 2;
    const PixelRect table = rectAlong(longer, {x, x + length}, {y, y + width});
    if (take(table)) drawTable(table, longer);
  }

  void drawTable(const PixelRect& table, int along) {
    drawLegs(table);
    const int across = 1 - along;
    const int step = scale_.pixels(850);
    for (int at = table.lo[along] + step / 2; at + step / 3 < table.hi[along]; at += step) {
      for (const bool hi : {false, true}) {
        const bool there = random_.chance(80);
        const int gap = scale_.pixels(random_.between(100, 400));
        if (!there) continue;
        std::array<int, 2> chair{};
        chair[along] = at;
        chair[across] = hi ? table.hi[across] + gap : table.lo[across] - gap;
        drawChair(chair);
      }
    }
  }

  void drawPillars(const PlannedRoom& room) {
    const int step = scale_.pixels(random_.between(4500, 6000));
    const int side = std::max(2, scale_.pixels(random_.between(350, 500)));
    for (int x = room.inside.lo[0] + step; x + step / 2 < room.inside.hi[0]; x += step) {
      for (int y = room.inside.lo[1] + step; y + step / 2 < room.inside.hi[1]; y += step) {
        const PixelRect pillar{{x, y}, {x + side, y + side}};
        if (take(pillar)) canvas_.fill(pillar, kOccupiedValue);
      }
    }
  }

  /// Groups of desks in the open.
  void drawIslands(const PlannedRoom& room) {
    const int tries = room.inside.length(0) / scale_.pixels(2500);
    for (int i = 0; i < tries; ++i) {
      const int along = random_.between(0, 1);
      const int length = scale_.pixels(random_.between(1600, 3200));
      const int width = scale_.pixels(1600);
      const int edge = scale_.pixels(1200);
      const PixelRect& floor = room.inside;
      if (floor.shorter() < length + 2 * edge) continue;
      const int x = random_.between(floor.lo[along] + edge, floor.hi[along] - edge - length);
      const int y = random_.between(floor.lo[1 - along] + edge, floor.hi[1 - along] - edge - width);
      const PixelRect island = rectAlong(along, {x, x + length}, {y, y + width});
      if (take(island)) drawTable(island, along);
    }
  }

  const OfficePlan& plan_;
  OfficeScale scale_;
  RandomSource& random_;
  GridCanvas& canvas_;
  std::vector<PixelRect> taken_;   ///< zones before doors and where corridors meet
  std::vector<PixelRect> pieces_;  ///< what stands in the room
};

}  // namespace

void drawFurniture(const OfficePlan& plan, const OfficeScale& scale, RandomSource& random,
                   GridCanvas& canvas) {
  Furnisher furnisher(plan, scale, random, canvas);
  for (const PlannedRoom& room : plan.rooms) furnisher.furnish(room);
}

}  // namespace agrid

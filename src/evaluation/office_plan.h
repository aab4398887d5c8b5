// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "evaluation/random_source.h"

namespace agrid {

/// Pixels [lo, hi) on either axis: 0 is x, 1 is y.
struct PixelRect {
  std::array<int, 2> lo{};
  std::array<int, 2> hi{};

  int length(int axis) const { return hi[axis] - lo[axis]; }
  int shorter() const { return length(0) < length(1) ? length(0) : length(1); }
  PixelRect grown(int by) const { return {{lo[0] - by, lo[1] - by}, {hi[0] + by, hi[1] + by}}; }
  bool overlaps(const PixelRect& other) const {
    return lo[0] < other.hi[0] && other.lo[0] < hi[0] && lo[1] < other.hi[1] && other.lo[1] < hi[1];
  }
};

/// A rectangle given by a range on one axis and a range on the other.
inline PixelRect rectAlong(int axis, std::array<int, 2> along, std::array<int, 2> across) {
  PixelRect rect;
  rect.lo[axis] = along[0];
  rect.hi[axis] = along[1];
  rect.lo[1 - axis] = across[0];
  rect.hi[1 - axis] = across[1];
  return rect;
}

/// Lengths of the real thing in pixels.
struct OfficeScale {
  double resolution = 0.05;  ///< [m]

  int pixels(int millimetres) const {
    return static_cast<int>(std::lround(millimetres / (1000 * resolution)));
  }
  int wall() const { return pixels(150) > 1 ? pixels(150) : 1; }
};

enum class RoomKind { kCorridor, kOffice, kMeeting, kHall };

struct PlannedRoom {
  PixelRect inside;  ///< its floor
  RoomKind kind = RoomKind::kOffice;
  std::uint16_t label = 0;             ///< the same for corridors that run into each other
  std::vector<std::size_t> doorways;   ///< indices into OfficePlan::doorways
  std::vector<std::size_t> junctions;  ///< indices into OfficePlan::junctions
};

struct Doorway {
  PixelRect opening;     ///< a hole in a wall
  int axis = 0;          ///< the axis that leads through it
  bool into_hi = false;  ///< the door opens towards larger coordinates
  bool shut = false;
};

/// Where a corridor runs into another.
struct Junction {
  PixelRect opening;     ///< the whole end of the corridor
  int axis = 0;          ///< the axis that leads through it
  std::size_t room = 0;  ///< the corridor
};

/// A building on paper: no pixel is drawn yet.
struct OfficePlan {
  PixelRect building;  ///< its outer wall lines
  std::vector<PlannedRoom> rooms;
  std::vector<Doorway> doorways;
  std::vector<Junction> junctions;
};

/// Divides a square building by corridors into blocks and these into rooms.
OfficePlan planOffice(int size, const OfficeScale& scale, RandomSource& random);

}  // namespace agrid

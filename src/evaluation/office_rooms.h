// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "evaluation/office_plan.h"

namespace agrid {

/// A part of the building between wall lines, with the corridors beside it.
struct Block {
  PixelRect lines;  ///< the lines that its walls are centred on
  /// The corridor (index of its room) at the lower and upper side of either axis; -1: none.
  std::array<std::array<int, 2>, 2> corridors{{{-1, -1}, {-1, -1}}};

  bool isWhole() const {
    return corridors[0][0] < 0 && corridors[0][1] < 0 && corridors[1][0] < 0 && corridors[1][1] < 0;
  }
};

/// A wall line: the axis it stands across and where.
struct WallPlace {
  int axis = 0;
  int line = 0;
};

enum class DoorSize { kSingle, kDouble };

/// A door to be made somewhere in the wall between two rooms.
struct DoorOrder {
  int room = 0;    ///< the room that it opens into
  int beyond = 0;  ///< the room on the other side
  int axis = 0;    ///< leads from one room to the other
  int line = 0;    ///< where the wall between them is
  DoorSize size = DoorSize::kSingle;
};

/// Fills blocks with rooms and makes their doors.
class RoomPlanner {
 public:
  RoomPlanner(const OfficeScale& scale, RandomSource& random) : scale_(scale), random_(random) {}

  /// Adds a room between wall lines; returns its index.
  int addRoom(const PixelRect& lines, RoomKind kind);
  /// Makes a door where both rooms share the wall; returns its index, -1 if it does not fit.
  int addDoor(const DoorOrder& order);
  /// Takes the wall between two corridors away.
  void addJunction(int corridor, int other, WallPlace place);
  /// Fills a block with rooms.
  void fill(const Block& block);
  /// The plan, rooms labelled from 1.
  OfficePlan takePlan();

 private:
  /// A row of rooms.
  struct Row {
    PixelRect lines;
    int axis = 0;           ///< the row runs along it
    int front = 0;          ///< the wall line that their doors are in
    int corridor = -1;      ///< behind that wall; -1: none, the rooms lead into each other
    bool all_used = false;  ///< none of its rooms stays locked
  };

  void fillFrom(const Block& block, int across, int side);
  void addHall(const Block& block);
  std::vector<int> addRow(const Row& row);
  void connectRow(const Row& row, const std::vector<int>& rooms);
  std::vector<int> addBackRow(const Row& row, const std::vector<int>& front);
  std::vector<int> cutLines(int from, int to);
  std::array<int, 2> sharedRange(int room, int other, int axis) const;
  int root(int room) const;

  OfficeScale scale_;
  RandomSource& random_;
  OfficePlan plan_;
  std::vector<int> merged_into_;  ///< for each room, the one that it runs into or itself
};

}  // namespace agrid

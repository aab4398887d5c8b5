// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "agrid/evaluation/office_generator.h"

namespace agrid::bench {

/// A drawn office that is rebuilt: doors are shut and opened, walls moved, drawn in and torn down,
/// rooms closed to the robot and added. What a room is follows the rule of people: of a divided
/// room, and of rooms that became one, the part that has at least two thirds of the floor is still
/// the room; if none has, all of them are new ones.
class ChangingOffice {
 public:
  ChangingOffice(int size, std::uint32_t seed);

  /// One or a few changes.
  void change();
  /// The map as a robot would bring it next: in a frame that is up to 0.15 m and 0.3 degrees off.
  OccupancyGrid grid();
  const std::vector<std::uint16_t>& rooms() const { return rooms_; }

 private:
  struct Box {
    Pixel low;
    Pixel high;  ///< included
  };

  int between(int low, int high);
  std::size_t at(int x, int y) const { return office_.grid.geometry.index({x, y}); }
  void toggleDoor();
  void moveWall();
  void divideRoom();
  void joinRooms();
  std::uint16_t randomRoom();
  Box boxOf(std::uint16_t room) const;
  /// Moves the wall between a room and another one into it, on one line of pixels.
  bool moveAlong(Pixel from, Pixel step, std::uint16_t room, int distance);
  void nameParts(std::uint16_t a, std::uint16_t b);
  double shareOf(std::uint16_t room, std::uint16_t of_both) const;

  Office office_;
  std::vector<std::int8_t> values_;
  std::vector<std::uint16_t> rooms_;
  std::vector<std::uint16_t> hidden_;  ///< rooms that were not seen yet
  std::vector<char> door_shut_;
  std::uint16_t next_room_ = 1;
  std::mt19937 random_;
};

}  // namespace agrid::bench

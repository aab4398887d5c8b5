// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "agrid/semantic_map.h"
#include "agrid/semantic_map/thing_lookup.h"
#include "support/ascii_map.h"

namespace agrid::dialogue::test {

/// Rooms drawn as rectangles of a letter, doors as digits in a wall that runs from left to right;
/// half a metre a character, the lower left corner at (0, 0). Made by hand, so that every test sees
/// where things are.
class DrawnHome {
 public:
  explicit DrawnHome(const std::vector<std::string>& rows) : rows_(rows) {
    std::vector<std::string> space = rows;
    for (std::string& row : space) {
      for (char& c : row) c = c == '#' ? '#' : '.';
    }
    map_.structure.map = std::make_shared<const OccupancyMap>(agrid::test::asciiMap(space, kSide));
  }

  DrawnHome& room(char letter, const std::string& name, const std::string& category = {}) {
    Area area;
    area.id = AreaId{static_cast<std::uint32_t>(map_.area_map.areas.size() + 1)};
    area.name = name;
    area.category = category;
    area.category_guess = "room";
    const auto [low, high] = cornersOf(letter);
    area.outline_map = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    area.anchor_map = (low + high) / 2;
    area.size = (high - low).prod();
    ids_[letter] = area.id;
    map_.area_map.areas.push_back(area);
    return *this;
  }

  DrawnHome& door(char digit, const std::string& name) {
    Door door;
    door.id = DoorId{static_cast<std::uint32_t>(digit - '0')};
    door.name = name;
    const auto [low, high] = cornersOf(digit);
    const double middle = (low.y() + high.y()) / 2;
    door.jambs_map = {{low.x(), middle}, {high.x(), middle}};
    door.areas = {idAt({low.x() + kSide / 2, high.y() + kSide / 2}),
                  idAt({low.x() + kSide / 2, low.y() - kSide / 2})};
    map_.area_map.doors.push_back(door);
    return *this;
  }

  DrawnHome& object(const std::string& name, const Point2& center, const std::string& category = {},
                    const Point2& size = {0.4, 0.4}) {
    ObjectTag tag;
    tag.id = ObjectId{static_cast<std::uint32_t>(map_.knowledge.objects.size() + 1)};
    tag.name = name;
    tag.category = category;
    tag.pose_map.position = center;
    tag.size = size;
    map_.knowledge.objects.push_back(tag);
    return *this;
  }

  SemanticMap map() {
    std::vector<std::uint16_t> labels;
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
      for (const char c : *row) labels.push_back(static_cast<std::uint16_t>(ids_[c]));
    }
    map_.area_map.pixel_labels = std::move(labels);
    return map_;
  }

 private:
  static constexpr double kSide = 0.5;  // of a pixel [m]

  std::pair<Point2, Point2> cornersOf(char letter) const {
    Point2 low(1e9, 1e9);
    Point2 high(-1e9, -1e9);
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (std::size_t column = 0; column < rows_[row].size(); ++column) {
        if (rows_[row][column] != letter) continue;
        const Point2 corner(static_cast<double>(column) * kSide,
                            static_cast<double>(rows_.size() - 1 - row) * kSide);
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner + Point2(kSide, kSide));
      }
    }
    return {low, high};
  }

  AreaId idAt(const Point2& point) {
    const auto column = static_cast<std::size_t>(point.x() / kSide);
    const auto row = rows_.size() - 1 - static_cast<std::size_t>(point.y() / kSide);
    return ids_[rows_.at(row).at(column)];
  }

  std::vector<std::string> rows_;
  std::map<char, AreaId> ids_;
  SemanticMap map_;
};

/// x from 0 to 12.5 m, y from 0 (bottom) to 6.5 m.
inline SemanticMap drawnHome() {
  return DrawnHome({
                       "#########################",  //
                       "#kkkkkkkk#llllllllllllll#",  // kitchen [0.5, 4.5] x [4, 6],
                       "#kkkkkkkk#llllllllllllll#",  // living room [5, 12] x [4, 6]
                       "#kkkkkkkk#llllllllllllll#",  //
                       "#kkkkkkkk#llllllllllllll#",  //
                       "####1########2###########",  // doors at y = 3.75
                       "#hhhhhhhhhhhhhhhhhhhhhhh#",  // hall [0.5, 12] x [2.5, 3.5]
                       "#hhhhhhhhhhhhhhhhhhhhhhh#",  //
                       "####3##########4#########",  // doors at y = 2.25
                       "#bbbbbbbbbbb#ttttttttttt#",  // bedroom [0.5, 6] x [0.5, 2],
                       "#bbbbbbbbbbb#ttttttttttt#",  // bath [6.5, 12] x [0.5, 2]
                       "#bbbbbbbbbbb#ttttttttttt#",  //
                       "#########################",
                   })
      .room('k', "kitchen")
      .room('l', "living room")
      .room('h', "hall", "corridor")
      .room('b', "bedroom")
      .room('t', "bath")
      .door('1', "kitchen door")
      .door('2', "door_2")
      .door('3', "door_3")
      .door('4', "door_4")
      .object("fridge", {1, 5.5}, "appliance")
      .object("oven", {2, 5.5}, "appliance")
      .object("sofa", {9, 5}, {}, {2, 1})
      .object("bed", {2, 1}, {}, {2, 1})
      .map();
}

/// The names of things, each followed by a semicolon.
inline std::string namesOf(const std::vector<Thing>& things) {
  std::string names;
  for (const Thing& thing : things) names += nameOf(thing) + ";";
  return names;
}

}  // namespace agrid::dialogue::test

// SPDX-License-Identifier: BSD-3-Clause
#include "identity/office_changes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace agrid::bench {
namespace {

constexpr int kWall = 3;     ///< thickness of a new wall [px]
constexpr int kMaxGap = 14;  ///< the thickest wall between two rooms [px]
constexpr double kStillTheRoom = 2. / 3;

}  // namespace

ChangingOffice::ChangingOffice(int size, std::uint32_t seed) : random_(seed) {
  OfficeParams params;
  params.size = size;
  params.seed = seed;
  params.noise = false;
  office_ = generateOffice(params);
  values_ = office_.grid.values;
  rooms_ = office_.rooms;
  door_shut_.assign(office_.doors_map.size(), 0);
  next_room_ = static_cast<std::uint16_t>(*std::max_element(rooms_.begin(), rooms_.end()) + 1);
  for (std::uint16_t room = 1; room < next_room_; ++room) {
    if (room % 5 == 0) hidden_.push_back(room);
  }
}

int ChangingOffice::between(int low, int high) {
  return low + static_cast<int>(random_() % static_cast<std::uint32_t>(high - low + 1));
}

void ChangingOffice::change() {
  for (int changes = between(1, 3); changes > 0; --changes) {
    const int kind = between(0, 9);
    if (kind < 4) {
      toggleDoor();
    } else if (kind < 6) {
      moveWall();
    } else if (kind < 7) {
      divideRoom();
    } else if (kind < 8) {
      joinRooms();
    } else if (!hidden_.empty()) {
      hidden_.pop_back();
    }
  }
}

OccupancyGrid ChangingOffice::grid() {
  OccupancyGrid grid = office_.grid;
  grid.values = values_;
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    if (std::find(hidden_.begin(), hidden_.end(), rooms_[i]) != hidden_.end()) grid.values[i] = -1;
  }
  const auto jitter = [this](double most) { return most * between(-100, 100) / 100; };
  const double x = jitter(0.15);
  const double y = jitter(0.15);
  const double middle = grid.geometry.width * grid.geometry.resolution / 2;
  const Pose2 about{Point2(middle, middle), jitter(0.3) * 3.14159265358979 / 180};
  grid.geometry.map_from_image = Pose2{Point2(x, y), 0} * about *
                                 inverse(Pose2{Point2(middle, middle), 0}) *
                                 grid.geometry.map_from_image;
  return grid;
}

void ChangingOffice::toggleDoor() {
  const auto door = static_cast<std::size_t>(between(0, static_cast<int>(door_shut_.size()) - 1));
  door_shut_[door] = door_shut_[door] == 0 ? 1 : 0;
  const MapGeometry& g = office_.grid.geometry;
  const Segment& jambs = office_.doors_map[door];
  const Point2 along = (jambs.b - jambs.a) / jambs.length();
  const Point2 across(-along.y(), along.x());
  for (double s = 0; s <= jambs.length(); s += g.resolution / 2) {
    for (double t = -1.1 * g.resolution; t <= 1.1 * g.resolution; t += g.resolution / 2) {
      const auto p = g.pixelAt(jambs.a + s * along + t * across);
      if (!p || rooms_[g.index(*p)] != 0) continue;
      values_[g.index(*p)] = static_cast<std::int8_t>(door_shut_[door] != 0 ? 100 : 0);
    }
  }
}

std::uint16_t ChangingOffice::randomRoom() {
  for (int trial = 0; trial < 50; ++trial) {
    const std::uint16_t room = rooms_[random_() % rooms_.size()];
    if (room != 0) return room;
  }
  return 0;
}

ChangingOffice::Box ChangingOffice::boxOf(std::uint16_t room) const {
  const MapGeometry& g = office_.grid.geometry;
  Box box{{g.width, g.height}, {-1, -1}};
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    if (rooms_[i] != room) continue;
    const Pixel p = g.pixel(i);
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool ChangingOffice::moveAlong(Pixel from, Pixel step, std::uint16_t room, int distance) {
  const MapGeometry& g = office_.grid.geometry;
  const auto pixel = [&](int k) { return Pixel{from.x + k * step.x, from.y + k * step.y}; };
  int behind = 1;
  while (behind <= kMaxGap && g.contains(pixel(behind)) && rooms_[g.index(pixel(behind))] == 0) {
    ++behind;
  }
  if (behind > kMaxGap || !g.contains(pixel(behind))) return false;
  const std::uint16_t other = rooms_[g.index(pixel(behind))];
  if (other == room) return false;
  for (int k = 1; k <= distance; ++k) {
    if (!g.contains(pixel(-k)) || rooms_[g.index(pixel(-k))] != room) return false;
  }
  for (int k = 1; k < behind; ++k) {  // the wall, with its doors
    values_[g.index(pixel(k - distance))] = values_[g.index(pixel(k))];
    rooms_[g.index(pixel(k - distance))] = 0;
  }
  for (int k = behind - distance; k < behind; ++k) {
    values_[g.index(pixel(k))] = 0;
    rooms_[g.index(pixel(k))] = other;
  }
  return true;
}

void ChangingOffice::moveWall() {
  const std::uint16_t room = randomRoom();
  if (room == 0) return;
  const Box box = boxOf(room);
  const int distance = between(4, 10);
  const int side = between(0, 3);
  const bool upright = side < 2;  // the wall runs along y
  const int length = upright ? box.high.x - box.low.x : box.high.y - box.low.y;
  if (length < 4 * distance) return;
  const bool far = side % 2 == 1;
  const Pixel step = upright ? Pixel{far ? 1 : -1, 0} : Pixel{0, far ? 1 : -1};
  const int low = upright ? box.low.y : box.low.x;
  const int high = upright ? box.high.y : box.high.x;
  const int line = upright ? (far ? box.high.x : box.low.x) : (far ? box.high.y : box.low.y);
  for (int k = low; k <= high; ++k) {
    const Pixel from = upright ? Pixel{line, k} : Pixel{k, line};
    if (rooms_[office_.grid.geometry.index(from)] == room) moveAlong(from, step, room, distance);
  }
}

double ChangingOffice::shareOf(std::uint16_t room, std::uint16_t of_both) const {
  const auto floor = [&](std::uint16_t r) {
    return static_cast<double>(std::count(rooms_.begin(), rooms_.end(), r));
  };
  return floor(room) / (floor(room) + floor(of_both));
}

/// What the two parts of room `a` are called, the one that is `b` until now among them.
void ChangingOffice::nameParts(std::uint16_t a, std::uint16_t b) {
  const double share = shareOf(a, b);
  if (share >= kStillTheRoom) return;
  const std::uint16_t fresh = next_room_++;
  for (std::uint16_t& room : rooms_) {
    if (1 - share >= kStillTheRoom && room == b) {
      room = a;
    } else if (room == a) {
      room = fresh;
    }
  }
}

void ChangingOffice::divideRoom() {
  const std::uint16_t room = randomRoom();
  if (room == 0) return;
  const Box box = boxOf(room);
  const bool upright = box.high.x - box.low.x > box.high.y - box.low.y;
  const int low = upright ? box.low.x : box.low.y;
  const int high = upright ? box.high.x : box.high.y;
  if (high - low < 70) return;
  const int line = between(low + 25, high - 25);
  const std::uint16_t part = next_room_++;
  for (int y = box.low.y; y <= box.high.y; ++y) {
    for (int x = box.low.x; x <= box.high.x; ++x) {
      if (rooms_[at(x, y)] != room) continue;
      const int k = upright ? x : y;
      if (k > line) rooms_[at(x, y)] = part;
      if (std::abs(k - line) > kWall / 2) continue;
      values_[at(x, y)] = 100;
      rooms_[at(x, y)] = 0;
    }
  }
  nameParts(room, part);
}

void ChangingOffice::joinRooms() {
  const std::uint16_t room = randomRoom();
  if (room == 0) return;
  const Box box = boxOf(room);
  std::map<std::uint16_t, std::vector<std::size_t>> between_rooms;
  for (int y = box.low.y; y <= box.high.y; ++y) {
    if (rooms_[at(box.high.x, y)] != room) continue;
    std::vector<std::size_t> gap;
    int x = box.high.x + 1;
    for (; x < office_.grid.geometry.width && x <= box.high.x + kMaxGap; ++x) {
      if (rooms_[at(x, y)] != 0) break;
      gap.push_back(at(x, y));
    }
    if (x >= office_.grid.geometry.width || rooms_[at(x, y)] == 0) continue;
    auto& all = between_rooms[rooms_[at(x, y)]];
    all.insert(all.end(), gap.begin(), gap.end());
  }
  if (between_rooms.empty()) return;
  const auto& [other, wall] = *between_rooms.begin();
  const Box beside = boxOf(other);
  const bool flush =
      std::abs(beside.low.y - box.low.y) < 8 && std::abs(beside.high.y - box.high.y) < 8;
  if (!flush) return;
  for (const std::size_t i : wall) {
    values_[i] = 0;
    rooms_[i] = room;
  }
  const double share = shareOf(room, other);
  const std::uint16_t kept = share >= kStillTheRoom       ? room
                             : 1 - share >= kStillTheRoom ? other
                                                          : next_room_++;
  std::replace_if(
      rooms_.begin(), rooms_.end(), [&](std::uint16_t r) { return r == room || r == other; }, kept);
}

}  // namespace agrid::bench

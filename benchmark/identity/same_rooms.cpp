// SPDX-License-Identifier: BSD-3-Clause
#include "identity/same_rooms.h"

#include <algorithm>
#include <ctime>
#include <iterator>

namespace agrid::bench {
namespace {

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// The id that each area of the new map keeps or gets: that of the tag whose seed lies in it.
std::vector<AreaId> idsOf(const Knowledge& knowledge, const SemanticMap& fresh) {
  std::vector<AreaId> ids(fresh.area_map.areas.size());
  for (const AreaTag& tag : knowledge.areas) {
    const auto pixel = fresh.map().geometry().pixelAt(tag.seed_map);
    if (!pixel) continue;
    const std::size_t label = fresh.area_map.pixel_labels[fresh.map().geometry().index(*pixel)];
    if (label != 0) ids[label - 1] = tag.id;
  }
  return ids;
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  same += other.same;
  kept += other.kept;
  again += other.again;
  back += other.back;
  rooms += other.rooms;
  lasting += other.lasting;
  names += other.names;
  named += other.named;
  waiting += other.waiting;
  swapped += other.swapped;
  joined += other.joined;
  area_seconds += other.area_seconds;
  seconds += other.seconds;
  return *this;
}

std::vector<std::optional<std::size_t>> Follower::areaOfRooms(
    const SemanticMap& fresh, const std::vector<std::uint16_t>& rooms) {
  const auto& labels = fresh.area_map.pixel_labels.vector();
  const std::size_t room_count = std::size_t{1} + *std::max_element(rooms.begin(), rooms.end());
  room_size_.assign(room_count, 0);
  std::vector<double> area_size(fresh.area_map.areas.size(), 0);
  rooms_of_area_.assign(area_size.size(), {});
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 0 || rooms[i] == 0) continue;
    room_size_[rooms[i]] += 1;
    area_size[labels[i] - 1U] += 1;
    rooms_of_area_[labels[i] - 1U][rooms[i]] += 1;
  }
  std::vector<std::optional<std::size_t>> area_of_room(room_count);
  for (std::size_t a = 0; a < area_size.size(); ++a) {
    for (const auto& [room, pixels] : rooms_of_area_[a]) {
      if (pixels > majority_ * area_size[a] && pixels > majority_ * room_size_[room]) {
        area_of_room[room] = a;
      }
    }
  }
  return area_of_room;
}

/// Where rooms are rebuilt: all maps have the same pixels.
void Follower::rememberFloors(const std::vector<std::uint16_t>& rooms) {
  if (!floors_.empty()) return;
  std::map<std::size_t, std::vector<std::size_t>> floors;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (rooms[i] != 0) floors[rooms[i]].push_back(i);
  }
  for (auto& [room, floor] : floors) floor_of_[room] = std::move(floor);
}

/// Whether a room lies for the most part where another was at last, and has most of its floor.
bool Follower::isHeir(std::size_t room, std::size_t of) const {
  if (room == of) return true;
  const auto floor = floor_of_.find(room);
  const auto former = floor_of_.find(of);
  if (floor == floor_of_.end() || former == floor_of_.end()) return false;
  std::vector<std::size_t> common;
  std::set_intersection(floor->second.begin(), floor->second.end(), former->second.begin(),
                        former->second.end(), std::back_inserter(common));
  return 2 * common.size() > floor->second.size() && 2 * common.size() > former->second.size();
}

void Follower::add(const SemanticMap& fresh, const std::vector<std::uint16_t>& rooms) {
  ++step_;
  const double start = processorSeconds();
  Recognition found = recognise(known_, "map", fresh, "map", params_);
  tally_.seconds += processorSeconds() - start;
  known_ = std::move(found.knowledge);
  const std::vector<AreaId> ids = idsOf(known_, fresh);
  rememberFloors(rooms);
  area_of_room_ = areaOfRooms(fresh, rooms);
  checkNames(ids);
  for (std::size_t room = 1; room < area_of_room_.size(); ++room) {
    if (area_of_room_[room]) follow(room, ids[*area_of_room_[room]], found.report);
  }
}

void Follower::nameIt(std::size_t room, AreaId id) {
  const AreaTag* tag = findTag(known_, id);
  const bool is_seen = floors_.empty() || 2 * room_size_[room] >= floors_[room];
  if (!is_seen || tag->source != TagSource::kAutomatic || !named_.insert(room).second) return;
  AreaTag named = *tag;
  named.name = "room " + std::to_string(room);
  named.source = TagSource::kManual;
  apply(PutTag{named}, known_);
  room_of_name_[id] = room;
}

void Follower::follow(std::size_t room, AreaId id, const std::vector<std::string>& report) {
  const auto [seen, is_new] = seen_.try_emplace(room, Seen{id, id, step_});
  if (room % 2 == 0) nameIt(room, id);
  if (is_new) return;
  const bool before = seen->second.step == step_ - 1;
  ++(before ? tally_.same : tally_.again);
  const AreaId last = seen->second.last;
  seen->second.last = id;
  seen->second.step = step_;
  if (last == id) {
    ++(before ? tally_.kept : tally_.back);
    return;
  }
  std::string loss = "step " + std::to_string(step_) + (before ? " lost" : " not back") +
                     ": room " + std::to_string(room) + " was " +
                     std::to_string(static_cast<int>(last)) + ", is " +
                     std::to_string(static_cast<int>(id));
  const std::string former = "area " + std::to_string(static_cast<int>(last)) + " ";
  for (const std::string& line : report) {
    if (line.rfind(former, 0) == 0) loss += "; " + line;
  }
  losses_.push_back(loss);
}

void Follower::checkNames(const std::vector<AreaId>& ids) {
  for (std::size_t a = 0; a < ids.size(); ++a) {
    const auto name = room_of_name_.find(ids[a]);
    if (name == room_of_name_.end()) continue;
    const std::size_t its_room = name->second;
    const bool holds_it =
        its_room < room_size_.size() && 2 * rooms_of_area_[a][its_room] > room_size_[its_room];
    for (std::size_t room = 1; room < area_of_room_.size(); ++room) {
      if (area_of_room_[room] != a || isHeir(room, its_room)) continue;
      ++(holds_it ? tally_.joined : tally_.swapped);
      losses_.push_back("step " + std::to_string(step_) + (holds_it ? " joined" : " swapped") +
                        ": name of room " + std::to_string(its_room) + " on room " +
                        std::to_string(room));
    }
  }
}

Tally Follower::finish() const {
  Tally tally = tally_;
  for (const auto& [room, seen] : seen_) {
    if (room >= area_of_room_.size() || !area_of_room_[room]) continue;
    ++tally.rooms;
    if (seen.first == seen.last) ++tally.lasting;
  }
  for (const auto& [id, room] : room_of_name_) {
    if (room >= area_of_room_.size() || !area_of_room_[room]) continue;
    ++tally.names;
    if (findTag(known_, id) == nullptr) {
      ++tally.waiting;
    } else if (seen_.at(room).last == id) {
      ++tally.named;
    }
  }
  return tally;
}

}  // namespace agrid::bench

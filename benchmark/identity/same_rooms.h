// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "agrid/identity/recognition.h"

namespace agrid::bench {

/// What became of ids and names over maps that follow each other.
///
/// An area *is* a true room if more than `majority` of its pixels in true rooms lie in that one,
/// and more than `majority` of the room's pixels that are in areas lie in it. A person would call
/// an area the same as one of the map before if both are the same room. Nothing of this knows how
/// areas are recognised.
struct Tally {
  std::size_t same = 0;     ///< areas that are a room which an area of the map before was
  std::size_t kept = 0;     ///< of them with its id
  std::size_t again = 0;    ///< areas that are a room which one of an earlier map was, but none of
                            ///< the map before
  std::size_t back = 0;     ///< of them with the id of the last one
  std::size_t rooms = 0;    ///< that some area was, and that are an area in the end
  std::size_t lasting = 0;  ///< of them with the first id still
  std::size_t names = 0;    ///< given to rooms that are an area in the end
  std::size_t named = 0;    ///< of them on their room in the end
  std::size_t waiting = 0;  ///< of them waiting in the end
  std::size_t swapped = 0;  ///< times that an area with the name of one room is another room
  std::size_t joined = 0;   ///< times that it is, but most of the named room lies in it as well
  double area_seconds = 0;  ///< of finding areas
  double seconds = 0;       ///< of recognising them

  Tally& operator+=(const Tally& other);
};

/// Follows what is known from map to map; a person names every second room as soon as it is an area
/// and half of its floor was seen.
class Follower {
 public:
  /// @param floors  free pixels of each true room that there are to see; empty: all are seen
  Follower(const RecognitionParams& params, double majority, std::vector<double> floors)
      : params_(params), majority_(majority), floors_(std::move(floors)) {}

  /// @param rooms  true rooms on the pixels of the map, 0 = none
  void add(const SemanticMap& fresh, const std::vector<std::uint16_t>& rooms);
  Tally finish() const;
  /// What was lost, for people, a sentence each.
  const std::vector<std::string>& losses() const { return losses_; }

 private:
  struct Seen {
    AreaId first{};
    AreaId last{};
    int step = 0;  ///< of the last
  };
  std::vector<std::optional<std::size_t>> areaOfRooms(const SemanticMap& fresh,
                                                      const std::vector<std::uint16_t>& rooms);
  void rememberFloors(const std::vector<std::uint16_t>& rooms);
  bool isHeir(std::size_t room, std::size_t of) const;
  void checkNames(const std::vector<AreaId>& ids);
  void nameIt(std::size_t room, AreaId id);
  void follow(std::size_t room, AreaId id, const std::vector<std::string>& report);

  RecognitionParams params_;
  double majority_;
  std::vector<double> floors_;
  Knowledge known_;
  std::map<std::size_t, Seen> seen_;                          ///< by room
  std::set<std::size_t> named_;                               ///< rooms
  std::map<AreaId, std::size_t> room_of_name_;                ///< by the id of the named area
  std::map<std::size_t, std::vector<std::size_t>> floor_of_;  ///< by room: its pixels, sorted
  // of the newest map
  std::vector<std::map<std::size_t, double>> rooms_of_area_;  ///< [px]
  std::vector<double> room_size_;                             ///< in areas [px]
  std::vector<std::optional<std::size_t>> area_of_room_;
  Tally tally_;
  std::vector<std::string> losses_;
  int step_ = 0;
};

}  // namespace agrid::bench

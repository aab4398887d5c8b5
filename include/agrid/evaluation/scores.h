// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "agrid/geometry/segment.h"
#include "agrid/map/occupancy_map.h"

namespace agrid {

/// How well areas agree with rooms drawn by people; all in [0, 1] but for mcc in [-1, 1].
struct AreaScores {
  double iou_all = 0;    ///< mean intersection over union of the best one-to-one pairs; rooms and
                         ///< areas without a partner count 0
  double iou_rooms = 0;  ///< the same sum over the number of rooms, for maps of which only a part
                         ///< has rooms
  double f1_50 = 0;      ///< F1 of these pairs, those of at least 0.5 being hits
  double mcc = 0;  ///< mean Matthews correlation of each pair over pixels labelled in both (Mielle
                   ///< et al. 2018); rooms and areas without a partner count 0
  double recall = 0;          ///< mean over rooms of the largest share that one area has of them
  double precision = 0;       ///< mean over areas of the largest share that one room has of them
  double recall_free = 0;     ///< recall on the free pixels alone
  double precision_free = 0;  ///< precision on the free pixels alone
  std::size_t areas = 0;      ///< areas that were counted
  std::size_t rooms = 0;      ///< rooms that were counted
  /// Rooms in each of which two areas or more lie by more than half, with a tenth of it or more.
  std::size_t over_segmented = 0;
  std::size_t under_segmented = 0;  ///< areas that hold more than half of two rooms or more
};

/// Which pixels of a room count for iou_all, iou_rooms, f1_50, mcc and the numbers.
enum class RoomFloor {
  kFree,  ///< those that are free on the map: rooms drawn with their furniture
  kAll,   ///< all: rooms drawn on this very map
};

/// Compares areas with rooms. Areas of at most 100 pixels are left out but for mcc, rooms of at
/// most 100 pixels always (Bormann et al. 2016, whose recall and precision these are: 'micro').
/// @param labels  row-major like the map: 0 = no area, k = area k
/// @param rooms  row-major like the map: 0 = no room, k = room k
/// @throws std::invalid_argument if the sizes differ
AreaScores scoreAreas(const OccupancyMap& map, const std::vector<std::uint16_t>& labels,
                      const std::vector<std::uint16_t>& rooms, RoomFloor floor = RoomFloor::kFree);

/// How well doors agree with the borders between rooms drawn by people.
struct DoorScores {
  double precision = 0;
  double recall = 0;
  std::size_t doors = 0;      ///< doors that were compared
  std::size_t borders = 0;    ///< true doors: borders between rooms
  std::vector<bool> is_true;  ///< for each door that was compared, whether it found a true one
};

/// Compares doors with rooms. The rooms are grown through the free pixels of the map until they
/// meet; each connected stretch of border between two, at least 0.2 m long, is a true door. It is
/// found if the middle of a door lies within `tolerance` of it; pairs are one to one.
/// @param map  without furniture
/// @param rooms  see scoreAreas
/// @param tolerance  [m]
/// @throws std::invalid_argument if the sizes differ
DoorScores scoreDoors(const OccupancyMap& map, const std::vector<Segment>& doors_map,
                      const std::vector<std::uint16_t>& rooms, double tolerance = 0.5);

/// The same where the true doors are known, jamb to jamb [m].
DoorScores scoreDoors(const std::vector<Segment>& doors_map,
                      const std::vector<Segment>& true_doors_map, double tolerance = 0.5);

}  // namespace agrid

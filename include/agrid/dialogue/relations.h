// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "agrid/geometry/pose2.h"
#include "agrid/semantic_map/thing_lookup.h"

namespace agrid::dialogue {

/// How one thing can lie to another, which is the landmark (Skubic et al., Spatial language for
/// human-robot dialogs, 2004, has the same ones). The names in questions are those of
/// `relationNames`.
enum class Relation {
  kIn,         ///< an object whose area the landmark is, or whose centre the landmark's box holds
  kNear,       ///< within `near`, in the same area unless one of both is an area
  kNextTo,     ///< as near, within `next_to`; of two areas also if they share a door or passage
  kNearestTo,  ///< the one least far away
  kNorthOf,    ///< in the sector around north, seen from the nearest point of the landmark
  kEastOf,
  kSouthOf,
  kWestOf,
  kLeftOf,  ///< to the left for the robot that looks at the landmark, within `side_range`
  kRightOf,
  kInFrontOf,  ///< on the robot's side of the landmark
  kBehind
};

/// in, near, next_to, nearest_to, north_of, east_of, south_of, west_of, left_of, right_of,
/// in_front_of, behind: in the order of the enumerators.
const std::vector<std::string>& relationNames();

struct RelationParams {
  double near = 2.0;        ///< between outlines [m], in [0, 100]
  double next_to = 0.5;     ///< between outlines [m], in [0, 100]: more than a wall's width
  double side_range = 5.0;  ///< of left, right, in front and behind [m], in [0, 1000]
  double sector_half_angle_deg = 45;  ///< of the eight directions, in [1, 90]
  double north_yaw_deg = 90;  ///< where north is in the map frame, from x, in [-360, 360]; 90: +y
};

/// What is wrong with parameters, naming field, value and bound; empty if nothing is.
std::string problemOf(const RelationParams& params);

/// What is asked for, such as all doors that are near the kitchen.
struct Question {
  Relation relation = Relation::kNear;
  std::string place;            ///< name, alias or category of the landmark
  bool place_is_robot = false;  ///< the landmark is the robot; of kIn: its area
  std::string what;             ///< name or category of what is asked for; empty: anything
  std::optional<TagKind> kind;  ///< only such things
};

/// A thing that lies so, and how far from the landmark.
struct Related {
  Thing thing;
  double distance = 0;  ///< between the outlines [m]
};

/// Whether a question cannot be answered without the robot's pose.
bool needsRobot(const Question& question);

/// What lies so, the nearest first, then areas before doors before objects. A word that means
/// several things makes all of them landmarks. The landmark itself, and what it is in, never lie
/// so.
/// @param robot  its pose in the map frame, looked from in the last four relations
/// @throws LookupError if a word of the question means nothing
/// @throws std::invalid_argument if a parameter is out of range, or there is no robot's pose and
///         the question needs it
std::vector<Related> findRelated(const SemanticMap& map, const Question& question,
                                 const std::optional<Pose2>& robot,
                                 const RelationParams& params = {});

/// A question in its terse form: 'near fridge', "near(fridge)", "near(door, fridge)",
/// "near(X, fridge)", the relation's name first, whatever the case; 'area', 'door' and 'object'
/// name a kind, 'robot' the robot, and a single capital or '_' stands for anything.
/// @return nothing if it is not one
std::optional<Question> terseQuestion(const std::string& text);

}  // namespace agrid::dialogue

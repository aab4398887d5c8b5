// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "agrid/dialogue/grammar.h"

namespace agrid::dialogue {

struct DialogueParams {
  RelationParams relations;
  double object_distance = 1.0;  ///< of what is said to be on a side of the robot [m], in (0, 100]
  double door_reach = 2.0;       ///< 'this door' is the nearest one within it [m], in (0, 100]
  std::size_t most_named = 8;    ///< things in an answer, at least 1; of the others, how many
};

/// What is wrong with parameters, naming field, value and bound; empty if nothing is.
std::string problemOf(const DialogueParams& params);

/// A tag that someone said; id 0: a new thing. Empty texts leave what was.
struct TagToPut {
  Tag tag;
  bool stays = false;  ///< nothing was said about where it is: the thing stays in its place
};

/// A thing that someone wants to be forgotten.
struct TagToDrop {
  TagKind kind = TagKind::kArea;
  std::uint32_t id = 0;
};

/// A door whose state someone said.
struct StateToSet {
  DoorId door{};
  DoorState state = DoorState::kUnknown;
};

using SpokenEdit = std::variant<TagToPut, TagToDrop, StateToSet>;

/// What a sentence leads to.
struct Reply {
  std::optional<SpokenEdit> edit;  ///< none: it was a question, or cannot be done
  std::string sentence;            ///< to say; if there is an edit, once it is done
  std::vector<Thing> things;       ///< that the answer is about, in its order
};

/// What to do or say when someone has said something: never throws for what was said.
/// @param robot  its pose in the map frame, none: it is not known
/// @throws std::invalid_argument if a parameter is out of range
Reply respond(const Grammar& grammar, const SemanticMap& map, const std::string& sentence,
              const std::optional<Pose2>& robot, const DialogueParams& params = {});

/// What to say if an edit was refused.
/// @param reason  a sentence without a full stop
std::string refusal(const Grammar& grammar, const std::string& reason);
/// What to say as long as there is no map.
std::string noMapYet(const Grammar& grammar);

enum class QueryStatus {
  kAnswered,
  kNotUnderstood,  ///< it is no question that is known
  kNoPose          ///< it needs the robot's pose
};

struct QueryAnswer {
  QueryStatus status = QueryStatus::kAnswered;
  std::string sentence;           ///< for a person
  std::vector<Thing> things;      ///< what was found, the nearest first
  std::vector<double> distances;  ///< of each from the landmark [m], of 'where is': the robot; NaN:
                                  ///< there is no landmark
};

/// The answer to a question about how things lie, in its terse form (terseQuestion) or as people
/// say it.
/// @throws LookupError if a word of the question means nothing
/// @throws std::invalid_argument if a parameter is out of range
QueryAnswer answerQuery(const Grammar& grammar, const SemanticMap& map, const std::string& question,
                        const std::optional<Pose2>& robot, const DialogueParams& params = {});

}  // namespace agrid::dialogue

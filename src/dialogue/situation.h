// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "agrid/dialogue/replies.h"
#include "dialogue/answers.h"

namespace agrid::dialogue {

/// Where something is said: what is known there, and how answers are worded.
struct Situation {
  const GrammarTables& tables;
  const SemanticMap& map;
  const std::optional<Pose2>& robot;
  const DialogueParams& params;

  std::string say(const std::string& key, const Slots& slots = {}) const {
    return dialogue::say(tables, key, slots);
  }
  /// Things by their names, joined.
  std::string namesOf(const std::vector<Thing>& things) const;
  /// How far a thing is from the robot, whose pose must be known [m].
  double distanceTo(const Thing& thing) const;
};

/// Why there is nothing to do; what to say is all that matters.
class CannotDo : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The edit that was said and what to say when it is done.
/// @throws CannotDo, LookupError
Reply replyTo(const SaidArea& said, const Situation& situation);
Reply replyTo(const SaidDoor& said, const Situation& situation);
Reply replyTo(const SaidObject& said, const Situation& situation);
Reply replyTo(const SaidState& said, const Situation& situation);
Reply replyTo(const SaidName& said, const Situation& situation);
Reply replyTo(const SaidForget& said, const Situation& situation);
Reply replyTo(const SaidForgetDoor& said, const Situation& situation);

/// The answer to a question, with how far each of the things is.
/// @throws LookupError
QueryAnswer answerTo(const AskedWhere& asked, const Situation& situation);
QueryAnswer answerTo(const AskedArea& asked, const Situation& situation);
QueryAnswer answerTo(const Question& question, const Situation& situation);

/// The door that is meant.
/// @throws CannotDo if there is none or more than one, LookupError
const Door& doorMeant(const WhichDoor& which, const Situation& situation);

/// The robot's pose.
/// @throws CannotDo if it is not known
const Pose2& requireRobot(const Situation& situation);

}  // namespace agrid::dialogue

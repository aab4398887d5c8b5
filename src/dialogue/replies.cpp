// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/dialogue/replies.h"

#include <stdexcept>
#include <type_traits>

#include "dialogue/situation.h"
#include "map/printable.h"
#include "semantic_map/shape.h"

namespace agrid::dialogue {
namespace {

constexpr std::size_t kLongestShown = 64;  // characters

/// The beginning of what was said, fit for an answer.
std::string shown(const std::string& text) {
  const auto sentence = sentenceOf(text);
  if (!sentence) return printable(text.substr(0, kLongestShown)) + "...";
  const std::u32string& said = sentence->as_said;
  return printable(utf8Of(said.substr(0, kLongestShown))) +
         (said.size() > kLongestShown ? "..." : "");
}

std::string textOf(const LookupError& error, const Situation& situation) {
  if (error.code() == LookupErrorCode::kBadName) return situation.say("bad_name");
  if (error.closest().empty()) {
    return situation.say("nothing_has_a_name", {{"word", error.word()}});
  }
  return situation.say("unknown_name", {{"word", error.word()},
                                        {"names", listText(situation.tables, error.closest())}});
}

/// Answers what is a question, does what is an edit.
struct Respond {
  const Situation& situation;
  const std::string& sentence;

  Reply operator()(const NotUnderstood&) const {
    return {std::nullopt, situation.say("not_understood", {{"sentence", shown(sentence)}}), {}};
  }
  Reply operator()(const AskedHelp&) const { return {std::nullopt, situation.say("help"), {}}; }
  template <typename Said>
  Reply operator()(const Said& said) const {
    constexpr bool kIsQuestion = std::is_same_v<Said, AskedWhere> ||
                                 std::is_same_v<Said, AskedArea> || std::is_same_v<Said, Question>;
    if constexpr (kIsQuestion) {
      QueryAnswer answer = answerTo(said, situation);
      return {std::nullopt, std::move(answer.sentence), std::move(answer.things)};
    } else {
      return replyTo(said, situation);
    }
  }
};

void requireValid(const DialogueParams& params) {
  const std::string problem = problemOf(params);
  if (!problem.empty()) throw std::invalid_argument(problem);
}

}  // namespace

std::string problemOf(const DialogueParams& params) {
  const auto is_length = [](double value) { return value > 0 && value <= 100; };
  if (!is_length(params.object_distance)) {
    return "object_distance is " + std::to_string(params.object_distance) + ", must be in (0, 100]";
  }
  if (!is_length(params.door_reach)) {
    return "door_reach is " + std::to_string(params.door_reach) + ", must be in (0, 100]";
  }
  if (params.most_named == 0) return "most_named is 0, must be at least 1";
  return problemOf(params.relations);
}

std::string Situation::namesOf(const std::vector<Thing>& things) const {
  std::vector<std::string> names;
  for (const Thing& thing : things) names.push_back(nameOf(thing));
  return listText(tables, names);
}

double Situation::distanceTo(const Thing& thing) const {
  return distanceBetween(shapeOf(thing), Shape({robot->position}));
}

const Pose2& requireRobot(const Situation& situation) {
  if (!situation.robot) throw CannotDo(situation.say("no_pose"));
  return *situation.robot;
}

Reply respond(const Grammar& grammar, const SemanticMap& map, const std::string& sentence,
              const std::optional<Pose2>& robot, const DialogueParams& params) {
  requireValid(params);
  const Situation situation{grammar.tables(), map, robot, params};
  try {
    return std::visit(Respond{situation, sentence}, understand(grammar, sentence));
  } catch (const CannotDo& error) {
    return {std::nullopt, error.what(), {}};
  } catch (const LookupError& error) {
    return {std::nullopt, textOf(error, situation), {}};
  }
}

std::string refusal(const Grammar& grammar, const std::string& reason) {
  return say(grammar.tables(), "refused", {{"reason", printable(reason)}});
}

std::string noMapYet(const Grammar& grammar) { return say(grammar.tables(), "no_map"); }

QueryAnswer answerQuery(const Grammar& grammar, const SemanticMap& map, const std::string& question,
                        const std::optional<Pose2>& robot, const DialogueParams& params) {
  requireValid(params);
  const Situation situation{grammar.tables(), map, robot, params};
  const Utterance utterance = understand(grammar, question);
  if (const auto* asked = std::get_if<Question>(&utterance)) return answerTo(*asked, situation);
  if (const auto* asked = std::get_if<AskedWhere>(&utterance)) return answerTo(*asked, situation);
  if (const auto* asked = std::get_if<AskedArea>(&utterance)) return answerTo(*asked, situation);
  if (const auto terse = terseQuestion(question)) return answerTo(*terse, situation);
  return {QueryStatus::kNotUnderstood,
          situation.say("not_understood", {{"sentence", shown(question)}}),
          {},
          {}};
}

}  // namespace agrid::dialogue

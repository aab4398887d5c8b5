// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue/intents.h"

#include <algorithm>
#include <array>
#include <locale>
#include <sstream>
#include <utility>

#include "agrid/tags/name.h"
#include "dialogue/grammar_tables.h"

namespace agrid::dialogue {
namespace {

constexpr double kFarthest = 1000;  // that a length can be said to be [m]

std::string in(const Slots& slots, const std::string& name) {
  const auto found = slots.find(name);
  return found == slots.end() ? std::string() : found->second;
}

WhichDoor doorIn(const Slots& slots) {
  return {in(slots, "door"), in(slots, "area"), in(slots, "other_area")};
}

Spot spotIn(const Slots& slots, Side side, const GrammarTables& tables) {
  Spot spot{side, std::nullopt};
  if (slots.count("distance")) spot.distance = numberIn(in(slots, "distance"), tables);
  return spot;
}

Question questionIn(const Slots& slots, Relation relation, const GrammarTables& tables) {
  Question question;
  question.relation = relation;
  const std::string place = in(slots, "place");
  const auto& robot = tables.robot;
  question.place_is_robot =
      place.empty() || std::find(robot.begin(), robot.end(), foldCase(place)) != robot.end();
  if (!question.place_is_robot) question.place = place;
  const std::string what = in(slots, "what");
  const auto kind = tables.kinds.find(foldCase(what));
  if (kind != tables.kinds.end()) {
    question.kind = kind->second;
  } else {
    question.what = what;
  }
  return question;
}

void addPlaced(std::vector<Intent>& intents) {
  constexpr std::array<std::pair<const char*, Side>, 5> kSides = {{{"here", Side::kHere},
                                                                   {"front", Side::kFront},
                                                                   {"left", Side::kLeft},
                                                                   {"right", Side::kRight},
                                                                   {"behind", Side::kBehind}}};
  for (const auto& [name, side] : kSides) {
    intents.push_back({std::string("add_door_") + name,
                       {},
                       {"name", "distance"},
                       [side = side](const Slots& slots, const GrammarTables& tables) {
                         return SaidDoor{in(slots, "name"), spotIn(slots, side, tables)};
                       }});
    intents.push_back(
        {std::string("add_object_") + name,
         {"name", "category"},
         {"distance"},
         [side = side](const Slots& slots, const GrammarTables& tables) {
           return SaidObject{in(slots, "name"), in(slots, "category"), spotIn(slots, side, tables)};
         }});
  }
}

void addStates(std::vector<Intent>& intents) {
  constexpr std::array<std::pair<const char*, DoorState>, 3> kStates = {
      {{"door_open", DoorState::kOpen},
       {"door_closed", DoorState::kClosed},
       {"door_unknown", DoorState::kUnknown}}};
  for (const auto& [name, state] : kStates) {
    intents.push_back({name,
                       {},
                       {"door", "area", "other_area"},
                       [state = state](const Slots& slots, const GrammarTables&) {
                         return SaidState{doorIn(slots), state};
                       }});
  }
}

void addQuestions(std::vector<Intent>& intents) {
  for (std::size_t i = 0; i < relationNames().size(); ++i) {
    const auto relation = static_cast<Relation>(i);
    intents.push_back({"ask_" + relationNames()[i],
                       {},
                       {"place", "what"},
                       [relation](const Slots& slots, const GrammarTables& tables) {
                         return questionIn(slots, relation, tables);
                       }});
  }
}

std::vector<Intent> makeIntents() {
  using Tables = GrammarTables;
  std::vector<Intent> intents;
  intents.push_back({"name_area", {"name", "category"}, {}, [](const Slots& s, const Tables&) {
                       return SaidArea{in(s, "name"), in(s, "category")};
                     }});
  addPlaced(intents);
  addStates(intents);
  intents.push_back({"rename", {"name"}, {"thing"}, [](const Slots& s, const Tables&) {
                       return SaidName{in(s, "thing"), in(s, "name")};
                     }});
  intents.push_back({"forget", {"thing"}, {}, [](const Slots& s, const Tables&) {
                       return SaidForget{in(s, "thing")};
                     }});
  intents.push_back(
      {"forget_door", {}, {"door", "area", "other_area"}, [](const Slots& s, const Tables&) {
         return SaidForgetDoor{doorIn(s)};
       }});
  intents.push_back({"where_is", {"thing"}, {}, [](const Slots& s, const Tables&) {
                       return AskedWhere{in(s, "thing")};
                     }});
  intents.push_back(
      {"which_area", {}, {}, [](const Slots&, const Tables&) { return AskedArea{}; }});
  addQuestions(intents);
  intents.push_back(
      {"not_understood", {}, {}, [](const Slots&, const Tables&) { return NotUnderstood{}; }});
  intents.push_back({"help", {}, {}, [](const Slots&, const Tables&) { return AskedHelp{}; }});
  return intents;
}

}  // namespace

const std::vector<Intent>& allIntents() {
  static const std::vector<Intent> kIntents = makeIntents();
  return kIntents;
}

std::optional<double> numberIn(const std::string& text, const GrammarTables& tables) {
  const auto word = tables.numbers.find(foldCase(text));
  if (word != tables.numbers.end()) return word->second;
  std::string digits = text;
  std::replace(digits.begin(), digits.end(), ',', '.');
  if (digits.empty() || digits.size() > 8 ||
      digits.find_first_not_of("0123456789.") != std::string::npos) {
    return std::nullopt;
  }
  std::istringstream stream(digits);
  stream.imbue(std::locale::classic());
  double number = 0;
  if (!(stream >> number) || !stream.eof() || number > kFarthest) return std::nullopt;
  return number;
}

}  // namespace agrid::dialogue

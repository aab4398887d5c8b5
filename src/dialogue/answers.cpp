// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue/answers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace agrid::dialogue {
namespace {

/// What is said when an edit is done.
std::vector<AnswerKey> whatWasDone() {
  return {
      {"area_named", {"name"}},
      {"area_is_a", {"category"}},
      {"door_added", {}},
      {"door_added_named", {"name"}},
      {"object_added", {"name"}},
      {"object_added_in", {"name", "area"}},
      {"object_moved", {"name"}},
      {"object_moved_in", {"name", "area"}},
      {"door_is_open", {"name"}},
      {"door_is_closed", {"name"}},
      {"door_is_unknown", {"name"}},
      {"renamed", {"thing", "name"}},
      {"forgotten", {"name"}},
  };
}

/// Why there is nothing to do.
std::vector<AnswerKey> whyNot() {
  return {
      {"refused", {"reason"}},
      {"no_map", {}},
      {"no_pose", {}},
      {"unknown_name", {"word", "names"}},
      {"nothing_has_a_name", {"word"}},
      {"bad_name", {}},
      {"several_meant", {"word", "names"}},
      {"no_area_here", {}},
      {"no_door_here", {"distance"}},
      {"no_such_door", {"areas"}},
  };
}

/// Answers about one thing.
std::vector<AnswerKey> whereThingsAre() {
  return {
      {"area_here", {"name"}},
      {"area_here_is_a", {"name", "category"}},
      {"object_is_in", {"name", "area"}},
      {"object_is_somewhere", {"name"}},
      {"area_is_next_to", {"name", "names"}},
      {"area_is_alone", {"name"}},
      {"door_is_between", {"name", "area", "other_area"}},
      {"door_is_of", {"name", "area"}},
      {"you_are_there", {"name"}},
      {"with_direction", {"answer", "distance", "side"}},
      {"without_direction", {"answer"}},
      {"side_front", {}},
      {"side_left", {}},
      {"side_right", {}},
      {"side_behind", {}},
  };
}

/// Answers to questions about relations, and the rest.
std::vector<AnswerKey> whatWasFound() {
  return {
      {"found", {"relation", "things"}},
      {"found_nothing", {"relation"}},
      {"thing_at", {"name", "distance"}},
      {"and_more", {"things", "count"}},
      {"the_robot", {}},
      {"not_understood", {"sentence"}},
      {"help", {}},
      {"list_separator", {}},
      {"list_last", {}},
  };
}

std::vector<AnswerKey> makeKeys() {
  std::vector<AnswerKey> keys;
  for (const auto section : {whatWasDone, whyNot, whereThingsAre, whatWasFound}) {
    for (AnswerKey& key : section()) keys.push_back(std::move(key));
  }
  for (const std::string& relation : relationNames()) {
    keys.push_back({"relation_" + relation, {"place"}});
  }
  return keys;
}

}  // namespace

const std::vector<AnswerKey>& allAnswerKeys() {
  static const std::vector<AnswerKey> kKeys = makeKeys();
  return kKeys;
}

std::string problemOfTemplate(const AnswerKey& key, const std::string& text) {
  for (std::size_t open = text.find('{'); open != std::string::npos;) {
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) return "'}' is missing";
    const std::string slot = text.substr(open + 1, close - open - 1);
    if (std::find(key.slots.begin(), key.slots.end(), slot) == key.slots.end()) {
      std::string known;
      for (const std::string& name : key.slots) known += " {" + name + "}";
      return "there is no slot {" + slot + "} here, there is" + (known.empty() ? " none" : known);
    }
    open = text.find('{', close);
  }
  return {};
}

std::string say(const GrammarTables& tables, const std::string& key, const Slots& slots) {
  const std::string& text = tables.answers.at(key);
  std::string said;
  std::size_t done = 0;
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', done)) {
    const std::size_t close = text.find('}', open);
    said += text.substr(done, open - done) + slots.at(text.substr(open + 1, close - open - 1));
    done = close + 1;
  }
  return said + text.substr(done);
}

std::string lengthText(const GrammarTables& tables, double length) {
  const auto tenths = static_cast<long long>(std::llround(std::min(length, 1e9) * 10));
  return std::to_string(tenths / 10) + tables.decimal_mark + std::to_string(tenths % 10);
}

std::string listText(const GrammarTables& tables, const std::vector<std::string>& items) {
  std::string list;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) list += say(tables, i + 1 == items.size() ? "list_last" : "list_separator");
    list += items[i];
  }
  return list;
}

}  // namespace agrid::dialogue

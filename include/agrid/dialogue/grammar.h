// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "agrid/dialogue/relations.h"

namespace agrid::dialogue {

/// On which side of the robot something is.
enum class Side { kHere, kFront, kLeft, kRight, kBehind };

struct Spot {
  Side side = Side::kHere;
  std::optional<double> distance;  ///< as said [m]
};

/// The words that tell a door; the one next to the robot if all are empty.
struct WhichDoor {
  std::string name;
  std::string area;        ///< one that it leads to
  std::string other_area;  ///< on its other side
};

/// 'this is the kitchen' (name), 'this is a kitchen' (category): the area that the robot is in.
struct SaidArea {
  std::string name;
  std::string category;
};

/// 'here is a door'
struct SaidDoor {
  std::string name;  ///< empty: none
  Spot spot;
};

/// 'there is a fridge in front of you' (category), 'the fridge is on your left' (name)
struct SaidObject {
  std::string name;
  std::string category;
  Spot spot;
};

/// 'this door is closed'
struct SaidState {
  WhichDoor door;
  DoorState state = DoorState::kUnknown;
};

/// 'door_3 is called back door', 'this door is called back door' (thing is empty)
struct SaidName {
  std::string thing;
  std::string name;
};

/// 'forget the fridge'
struct SaidForget {
  std::string thing;
};

/// 'there is no door here', 'forget the door between the kitchen and the hall'
struct SaidForgetDoor {
  WhichDoor door;
};

/// 'where is the kitchen'
struct AskedWhere {
  std::string thing;
};

/// 'which room is this'
struct AskedArea {};

/// 'what can I say'
struct AskedHelp {};

struct NotUnderstood {};

/// What a sentence means; the words in it are as they were said.
using Utterance =
    std::variant<SaidArea, SaidDoor, SaidObject, SaidState, SaidName, SaidForget, SaidForgetDoor,
                 AskedWhere, AskedArea, Question, AskedHelp, NotUnderstood>;

struct GrammarTables;

/// Which sentences mean what, and how answers are worded, in one language (doc/dialogue.md). Copies
/// share what they hold; never changed after it was read.
class Grammar {
 public:
  explicit Grammar(std::shared_ptr<const GrammarTables> tables) : tables_(std::move(tables)) {}
  const GrammarTables& tables() const { return *tables_; }

 private:
  std::shared_ptr<const GrammarTables> tables_;
};

/// The grammar in a file of at most 1 MB.
/// @throws FileError naming file, line, column and key, and what is wrong
Grammar loadGrammar(const std::string& path);

/// The grammar in a text.
/// @param name  of the text, for messages
/// @throws FileError (kYaml), as loadGrammar
Grammar parseGrammar(const std::string& text, const std::string& name);

/// That of config/grammar_en.yaml, as it was when this library was built.
const Grammar& englishGrammar();

/// What a sentence means. Case, punctuation around words and polite phrases do not matter; of the
/// patterns that fit, that with the most letters of its own counts, then the first one.
Utterance understand(const Grammar& grammar, const std::string& sentence);

}  // namespace agrid::dialogue

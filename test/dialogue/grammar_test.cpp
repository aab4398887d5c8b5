// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/dialogue/grammar.h"

#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "agrid/dialogue/replies.h"
#include "agrid/map/map_io.h"
#include "dialogue/answers.h"
#include "drawn_home.h"

namespace agrid::dialogue {
namespace {

const std::string kConfig = AGRID_TEST_DATA "/../../config/";

std::string textOf(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

const std::string& english() {
  static const std::string kText = textOf(kConfig + "grammar_en.yaml");
  return kText;
}

/// What is wrong with the English grammar if a part of it is replaced, empty if nothing is.
std::string problemIf(const std::string& part, const std::string& replacement) {
  std::string text = english();
  const std::size_t at = text.find(part);
  if (at == std::string::npos) return "not in the file: " + part;
  text.replace(at, part.size(), replacement);
  try {
    parseGrammar(text, "mine.yaml");
  } catch (const FileError& error) {
    EXPECT_EQ(error.code(), FileErrorCode::kYaml);
    return error.what();
  }
  return "";
}

/// The number of the first line that holds a text, as a message shows it.
std::string lineOf(const std::string& part) {
  const std::string before = english().substr(0, english().find(part));
  return "mine.yaml:" + std::to_string(std::count(before.begin(), before.end(), '\n') + 1) + ":";
}

TEST(Grammar, TheEnglishOneIsPartOfTheLibrary) {
  const Grammar file = loadGrammar(kConfig + "grammar_en.yaml");
  EXPECT_EQ(file.tables().answers, englishGrammar().tables().answers);
  EXPECT_EQ(file.tables().ways.size(), englishGrammar().tables().ways.size());
  EXPECT_TRUE(std::holds_alternative<SaidArea>(understand(file, "this is the kitchen")));
}

TEST(Grammar, EverySlotOfEveryAnswerCanBeFilled) {
  for (const char* name : {"grammar_en.yaml", "grammar_de.yaml"}) {
    const Grammar grammar = loadGrammar(kConfig + name);
    for (const AnswerKey& key : allAnswerKeys()) {
      Slots slots;
      for (const std::string& slot : key.slots) slots[slot] = "<" + slot + ">";
      const std::string said = say(grammar.tables(), key.key, slots);
      EXPECT_EQ(said.find('{'), std::string::npos) << said;
      for (const std::string& slot : key.slots) {
        EXPECT_NE(said.find("<" + slot + ">"), std::string::npos) << key.key << " of " << name;
      }
    }
  }
}

TEST(Grammar, EveryIntentCanBeSaidInEveryLanguage) {
  for (const char* name : {"grammar_en.yaml", "grammar_de.yaml"}) {
    const Grammar grammar = loadGrammar(kConfig + name);
    for (const Intent& intent : allIntents()) {
      const auto& ways = grammar.tables().ways;
      EXPECT_TRUE(std::any_of(ways.begin(), ways.end(),
                              [&](const Way& way) { return way.intent == &intent; }))
          << intent.key << " of " << name;
    }
  }
}

TEST(Grammar, AnotherLanguage) {
  const Grammar grammar = loadGrammar(kConfig + "grammar_de.yaml");
  const SemanticMap map = test::DrawnHome({"#########", "#kkk#fff#", "#kkk1fff#", "#########"})
                              .room('k', "K\xc3\xbc\x63he")
                              .room('f', "Flur")
                              .object("K\xc3\xbchlschrank", {1, 1})
                              .map();
  const auto reply = [&](const std::string& sentence) {
    return respond(grammar, map, sentence, Pose2{{1.5, 1}, 0});
  };
  EXPECT_EQ(reply("Wo ist die K\xc3\x9c\x43HE?").sentence, "Wir sind gerade in K\xc3\xbc\x63he.");
  EXPECT_EQ(reply("wo steht der K\xc3\xbchlschrank").sentence,
            "K\xc3\xbchlschrank ist in K\xc3\xbc\x63he, 0,3 m entfernt, hinter mir.");
  EXPECT_EQ(reply("was ist neben der K\xc3\xbc\x63he").sentence,
            "neben K\xc3\xbc\x63he: Flur (0,5 m).");
  EXPECT_EQ(reply("was ist \xc3\xb6stlich von der K\xc3\xbc\x63he").things.size(), 1U);
  EXPECT_EQ(reply("koch Kaffee").sentence.substr(0, 17), "\xe2\x80\x9ekoch Kaffee\xe2\x80\x9c");
  const Reply table = reply("Zwei Meter vor dir steht ein Tisch.");
  ASSERT_TRUE(table.edit);
  const auto tag = std::get<ObjectTag>(std::get<TagToPut>(*table.edit).tag);
  EXPECT_EQ(tag.name, "Tisch");
  EXPECT_TRUE(tag.pose_map.position.isApprox(Point2(3.5, 1)));
  EXPECT_TRUE(std::holds_alternative<SaidDoor>(understand(grammar, "hier ist eine T\xc3\xbcr")));
  EXPECT_TRUE(std::holds_alternative<SaidState>(understand(grammar, "diese T\xc3\x9cR ist zu")));
  EXPECT_TRUE(std::holds_alternative<SaidForget>(understand(grammar, "bitte vergiss den Tisch")));
}

TEST(Grammar, SentencesCanBeAdded) {
  std::string text = english();
  text.replace(text.find("    - this is [<the>] {name}\n"), 0,
               "    - '\xe8\xbf\x99\xe6\x98\xaf{name}'\n"
               "    - (welcome|come in) to [<the>] {name} of {name:* house}\n");
  EXPECT_THROW(parseGrammar(text, "x"), FileError);  // two names
  text = english();
  text.replace(text.find("    - this is [<the>] {name}\n"), 0,
               "    - '\xe8\xbf\x99\xe6\x98\xaf{name}'\n    - welcome to [<the>] {name}\n");
  const Grammar grammar = parseGrammar(text, "mine.yaml");
  EXPECT_EQ(std::get<SaidArea>(understand(grammar, "Welcome to the Lab!")).name, "Lab");
  // a language without spaces
  const auto said =
      understand(grammar, "\xe8\xbf\x99\xe6\x98\xaf\xe5\x8e\xa8\xe6\x88\xbf\xe3\x80\x82");
  EXPECT_EQ(std::get<SaidArea>(said).name, "\xe5\x8e\xa8\xe6\x88\xbf");
}

TEST(Grammar, WhatIsWrongIsSaidWithItsLine) {
  struct Case {
    std::string part;
    std::string replacement;
    std::string message;
  };
  const std::vector<Case> cases = {
      {"this is [<the>] {name}", "this is [<the> {name}", "']' is missing"},
      {"this is [<the>] {name}", "this is <teh> {name}", "there is no list <teh>"},
      {"this is [<the>] {name}", "this is {nmae}", "there is no slot {nmae} here, there is {name}"},
      {"this is [<the>] {name}", "this is it", "exactly one of the slots"},
      {"this is [<the>] {name}", "this is {name|x}", "stands where '}' must"},
      {"this is [<the>] {name}", "'{name}'", "no words of its own"},
      {"this is [<the>] {name}", "this is {name}?", "leave out '?'"},
      {"this is [<the>] {name}", "this is {name})", "')' is not open"},
      {"this is [<the>] {name}", "'this is {}'", "a name of small letters is missing"},
      {"this is [<the>] {name}", "this is ((((((((((({name})))))))))))", "nested too deeply"},
      {"this is [<the>] {name}", "this is {name} " + std::string(1000, 'x'), "longer than 1000"},
      {"this is [<the>] {name}", "[a, b]", "must be a text"},
      {"  name_area:", "  nam_area:", "nearest is 'name_area'"},
      {"decimal_mark:", "decimal_mrk:", "nearest is 'decimal_mark'"},
      {"area_here: We are in {name}.", "area_here: We are in {area}.",
       "there is no slot {area} here, there is {name}"},
      {"area_here: We are in {name}.", "area_here: We are in {name.", "'}' is missing"},
      {"area_here: We are in {name}.", "are_here: x", "nearest is 'area_here'"},
      {"half a: 0.5", "half a: much", "must be a number"},
      {"  area: [area,", "  aera: [area,", "nearest is 'area'"},
      {"the: [the, my", "the: ['<a>', my", "a list cannot hold a list"},
  };
  for (const Case& c : cases) {
    const std::string problem = problemIf(c.part, c.replacement);
    EXPECT_NE(problem.find(c.message), std::string::npos) << problem;
    EXPECT_EQ(problem.find(lineOf(c.part)), 0U) << problem << "; " << lineOf(c.part);
  }
}

TEST(Grammar, WhatIsMissingOrTwice) {
  EXPECT_NE(problemIf("  no_map: I have no map yet.\n", "").find("answers: missing: no_map"),
            std::string::npos);
  EXPECT_NE(problemIf("language: English\n", "").find("key 'language' is missing"),
            std::string::npos);
  EXPECT_NE(problemIf("language: English\n", "language: English\nlanguage: x\n").find("twice"),
            std::string::npos);
  EXPECT_NE(problemIf("agrid_map grammar 1", "agrid_map grammar 2").find("must be"),
            std::string::npos);
  EXPECT_NE(problemIf("lists:\n", "lists: [\n").find("mine.yaml:"), std::string::npos);
}

TEST(Grammar, FilesThatCannotBeRead) {
  EXPECT_THROW(loadGrammar("/nonexistent/grammar.yaml"), FileError);
  EXPECT_THROW(loadGrammar("/dev/zero"), FileError);
  for (const char* text : {"", "a", "[]", "- a\n- b", "{", "\xff\xfe", "a: *b", "? {a: b} : c"}) {
    EXPECT_THROW(parseGrammar(text, "x"), FileError) << text;
  }
  EXPECT_THROW(parseGrammar(std::string(100000, '['), "x"), FileError);
}

TEST(Grammar, RandomDamageNeverDoesHarm) {
  std::mt19937 random(21);
  int usable = 0;
  for (int i = 0; i < 400; ++i) {
    std::string text = english();
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) {
        text[at] = static_cast<char>(random());
      } else {
        text.erase(at, random() % 40);
      }
    }
    try {
      const Grammar grammar = parseGrammar(text, "x");
      understand(grammar, "this is the kitchen");
      ++usable;
    } catch (const FileError& error) {
      EXPECT_EQ(std::string(error.what()).find("x:"), 0U);
    }
  }
  EXPECT_GT(usable, 0);
  EXPECT_LT(usable, 400);
}

TEST(Grammar, RandomBytesNeverDoHarm) {
  std::mt19937 random(22);
  const std::string likely = "{}[]:,-#&*!|>'\"%@` \n\tab";
  for (int i = 0; i < 3000; ++i) {
    std::string text(random() % 60, ' ');
    for (char& c : text) {
      c = random() % 4 == 0 ? static_cast<char>(random()) : likely[random() % likely.size()];
    }
    EXPECT_THROW(parseGrammar(text, "x"), FileError);
  }
}

TEST(Grammar, NoPatternTakesForEver) {
  std::string text = english();
  std::string greedy = "    - 'x";
  for (int i = 0; i < 30; ++i) greedy += "[a|a|*] ";
  text.replace(text.find("    - this is [<the>] {name}\n"), 0, greedy + "{name}'\n");
  const Grammar grammar = parseGrammar(text, "mine.yaml");
  EXPECT_NO_THROW(understand(grammar, "x " + std::string(400, 'a')));
}

}  // namespace
}  // namespace agrid::dialogue

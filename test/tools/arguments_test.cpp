// SPDX-License-Identifier: BSD-3-Clause
#include "tools/arguments.h"

#include <gtest/gtest.h>

namespace agrid::tools {
namespace {

using Words = std::vector<std::string>;

Syntax syntax() {
  Syntax s;
  s.command = "paint";
  s.summary = "Paints a wall.";
  s.operands = {"WALL"};
  s.options = {
      {"color", 'c', "NAME", "which colour", true, false},
      {"coats", 0, "N", "how many", false, false},
      {"wet", 'w', "", "do not dry", false, false},
      {"tool", 't', "NAME", "brushes", false, true},
  };
  return s;
}

std::string complaint(const Words& words) {
  try {
    Arguments(syntax(), words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Arguments, TakesOptionsInEveryForm) {
  for (const Words& words : {Words{"w1", "--color", "red"}, Words{"--color=red", "w1"},
                             Words{"-c", "red", "w1"}, Words{"-cred", "w1"}}) {
    const Arguments arguments(syntax(), words);
    EXPECT_EQ(arguments.operand(0), "w1");
    EXPECT_EQ(arguments.value("color"), "red");
    EXPECT_FALSE(arguments.has("wet"));
  }
}

TEST(Arguments, TwoDashesEndTheOptions) {
  const Arguments arguments(syntax(), {"-c", "red", "--", "--wet"});
  EXPECT_EQ(arguments.operand(0), "--wet");
  EXPECT_FALSE(arguments.has("wet"));
}

TEST(Arguments, RepeatedOptionsKeepTheirOrder) {
  const Arguments arguments(syntax(), {"w1", "-c", "red", "-t", "roller", "--tool", "brush"});
  EXPECT_EQ(arguments.values("tool"), (Words{"roller", "brush"}));
  EXPECT_TRUE(arguments.values("coats").empty());
  EXPECT_EQ(arguments.valueOr("coats", "1"), "1");
}

TEST(Arguments, F28_WrongWordsAreNamed) {
  EXPECT_EQ(complaint({"w1", "-c", "red", "--gloss"}), "unknown option '--gloss'");
  EXPECT_EQ(complaint({"w1", "-c", "red", "-x"}), "unknown option '-x'");
  EXPECT_EQ(complaint({"w1", "--color"}), "option '--color' needs a value");
  EXPECT_EQ(complaint({"w1", "--color", "--wet"}), "option '--color' needs a value");
  EXPECT_EQ(complaint({"w1", "-c", "red", "--wet=yes"}), "option '--wet' takes no value");
  EXPECT_EQ(complaint({"w1", "-c", "red", "-c", "blue"}), "option '--color' is given twice");
  EXPECT_EQ(complaint({"-c", "red"}), "WALL is missing");
  EXPECT_EQ(complaint({"w1", "w2", "-c", "red"}), "unexpected 'w2'");
  EXPECT_EQ(complaint({"w1"}), "option '--color' is missing");
}

TEST(Arguments, HelpNeedsNothingElse) {
  EXPECT_TRUE(Arguments(syntax(), {"--help"}).has("help"));
  EXPECT_TRUE(Arguments(syntax(), {"-h"}).has("help"));
}

TEST(Arguments, NumbersAreCheckedAsAWhole) {
  const auto coats = [](const std::string& text) {
    return Arguments(syntax(), {"w1", "-c", "red", "--coats", text});
  };
  EXPECT_EQ(coats("3").integerOr("coats", 1, 1, 9), 3);
  EXPECT_EQ(coats("-3").integerOr("coats", 1, -9, 9), -3);
  EXPECT_DOUBLE_EQ(coats("2.5e-1").numberOr("coats", 1, 0, 9), 0.25);
  for (const char* wrong : {"", "x", "3x", "0", "10", "2.5", "1e1", " 3", "99999999999999999999"}) {
    EXPECT_THROW(coats(wrong).integerOr("coats", 1, 1, 9), UsageError) << wrong;
  }
  for (const char* wrong : {"", "x", "3x", "-1", "10", "nan", "inf", "1,5", " 3", "1e999"}) {
    EXPECT_THROW(coats(wrong).numberOr("coats", 1, 0, 9), UsageError) << wrong;
  }
  const Arguments none(syntax(), {"w1", "-c", "red"});
  EXPECT_EQ(none.integerOr("coats", 7, 1, 9), 7);
  EXPECT_DOUBLE_EQ(none.numberOr("coats", 0.5, 0, 9), 0.5);
}

TEST(Arguments, HelpShowsEveryOption) {
  EXPECT_EQ(usageLine(syntax()),
            "usage: agrid_map_tool paint WALL -c NAME [--coats N] [-w] [-t NAME]");
  const std::string help = helpText(syntax());
  for (const char* part :
       {"Paints a wall.", "-c, --color NAME", "--coats N", "-w, --wet", "--help"}) {
    EXPECT_NE(help.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace agrid::tools

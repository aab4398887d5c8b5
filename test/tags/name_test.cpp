// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/tags/name.h"

#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "map/utf8.h"

namespace agrid {
namespace {

TEST(Name, T8_NamesOfAnyLanguage) {
  for (const std::string name :
       {"k", "room 315", " kitchen ", "K\xc3\xbc\x63he", "caff\xc3\xa8 d'angolo, 2\xc2\xba piano",
        "\xe5\x8e\xa8\xe6\x88\xbf", "\xf0\x9f\x8d\xb3 kitchen", "a: b", "*a", "../../etc/x",
        "\xd7\x9e\xd7\x98\xd7\x91\xd7\x97", "\xf0\x9f\x91\xa9\xe2\x80\x8d\xf0\x9f\x8d\xb3"}) {
    EXPECT_EQ(problemOfName(name), "") << name;
  }
  EXPECT_EQ(problemOfName(std::string(256, 'a')), "");
}

TEST(Name, T8_WhatIsNoName) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "empty"},
      {std::string(257, 'a'), "257 bytes"},
      {std::string(86 * 3, '\xe5'), "258 bytes"},
      {"\xff", "UTF-8"},
      {"\xed\xa0\x80", "UTF-8"},
      {"a\nb", "control"},
      {std::string("a\0b", 3), "control"},
      {"\xc2\x85", "control"},
      {"a\xe2\x80\xa8\x62", "line break"},            // U+2028
      {"gpj.\xe2\x80\xae\x61", "direction"},          // U+202E
      {"\xe2\x81\xa6\x61\xe2\x81\xa9", "direction"},  // U+2066, U+2069
      {"   ", "spaces"},
      {"\xc2\xa0\xe3\x80\x80\xe2\x80\x8b", "spaces"},  // no-break, ideographic, of no width
  };
  for (const auto& [name, problem] : cases) {
    EXPECT_NE(problemOfName(name).find(problem), std::string::npos) << problemOfName(name);
  }
}

TEST(Name, T8_AProblemIsShortAndShowsNothingHarmful) {
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    std::string name(random() % 300, ' ');
    for (char& c : name) c = static_cast<char>(random());
    if (i % 2 == 0) name += "\xe2\x80\xae";
    const std::string problem = problemOfName(name);
    EXPECT_LT(problem.size(), 400U);
    const auto shown = codePointsOf(problem);
    ASSERT_TRUE(shown);
    for (const char32_t c : *shown) EXPECT_TRUE(c >= 0x20 && c != 0x202E);
  }
  EXPECT_NE(problemOfName(std::string(1000, 'a')).find("aaa...'"), std::string::npos);
}

TEST(Name, SmallLettersOfManyScripts) {
  EXPECT_EQ(foldCase("Kitchen 2B"), "kitchen 2b");
  EXPECT_EQ(foldCase("\xc3\x9c\x42UNG"), "\xc3\xbc\x62ung");
  EXPECT_EQ(foldCase("\xc5\xbb\xc3\x93\xc5\x81\xc4\x86"),
            "\xc5\xbc\xc3\xb3\xc5\x82\xc4\x87");  // Polish
  EXPECT_EQ(foldCase("\xce\x9f\xce\xb4\xcf\x8c\xcf\x82"),
            "\xce\xbf\xce\xb4\xcf\x8c\xcf\x83");                // Greek
  EXPECT_EQ(foldCase("\xd0\x81\xd0\x96"), "\xd1\x91\xd0\xb6");  // Cyrillic
  EXPECT_EQ(foldCase("\xe1\xba\x9e"), "\xc3\x9f");              // the long way from U+1E9E
  EXPECT_EQ(foldCase("\xe5\x8e\xa8 \xf0\x9f\x8d\xb3"), "\xe5\x8e\xa8 \xf0\x9f\x8d\xb3");
  EXPECT_EQ(foldCase("\xc3\x97\xc3\xb7"), "\xc3\x97\xc3\xb7");  // signs among the letters
  EXPECT_EQ(foldCase("A\xff"
                     "B\xc3\x9c"),
            "a\xff"
            "b\xc3\x9c");  // not UTF-8
}

TEST(Name, FoldingTwiceIsFoldingOnce) {
  for (char32_t c = 1; c < 0x11000; ++c) {
    if (c >= 0xD800 && c < 0xE000) continue;
    std::string text;
    appendUtf8(text, c);
    ASSERT_EQ(codePointsOf(text), std::u32string(1, c));
    EXPECT_EQ(foldCase(foldCase(text)), foldCase(text)) << static_cast<unsigned>(c);
  }
}

}  // namespace
}  // namespace agrid

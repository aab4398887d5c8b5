// SPDX-License-Identifier: BSD-3-Clause
#include "semantic_map/closest_names.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace agrid {
namespace {

/// The definition, without the table.
std::size_t slowDistance(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::string shorter_a = a.substr(1);
  const std::string shorter_b = b.substr(1);
  return std::min({slowDistance(shorter_a, shorter_b) + (a[0] == b[0] ? 0 : 1),
                   slowDistance(shorter_a, b) + 1, slowDistance(a, shorter_b) + 1});
}

TEST(ClosestNames, EditDistanceIsTheDefinitions) {
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    std::string a(random() % 6, 'a');
    std::string b(random() % 6, 'a');
    for (char& c : a) c = static_cast<char>('a' + random() % 3);
    for (char& c : b) c = static_cast<char>('a' + random() % 3);
    EXPECT_EQ(editDistance(a, b), slowDistance(a, b)) << a << " " << b;
  }
}

TEST(ClosestNames, NearestFirstEachOnce) {
  EXPECT_EQ(closestNames("area_12", {"hall", "Area_1", "area_2", "area_2"}, 2),
            (std::vector<std::string>{"Area_1", "area_2"}));
  EXPECT_TRUE(closestNames("x", {}).empty());
}

TEST(ClosestNames, CharactersAreNotBytes) {
  EXPECT_EQ(editDistance("K\xc3\xbc\x63he", "Kuche"), 1U);
  EXPECT_EQ(editDistance("\xe5\x8e\xa8\xe6\x88\xbf", "\xe5\x8e\xa8"), 1U);
  EXPECT_EQ(editDistance("\xff\xfe", "\xff"), 1U);  // not UTF-8
  // two characters away by characters, but four by bytes
  EXPECT_EQ(closestNames("\xe5\x8e\xa8\xe6\x88\xbf", {"\xe5\xae\xa2\xe5\x8e\x85", "abc"}, 1),
            std::vector<std::string>{"\xe5\xae\xa2\xe5\x8e\x85"});
}

TEST(ClosestNames, CapitalsCountAsSmallLetters) {
  EXPECT_EQ(closestNames("\xc3\x9c\x42ung", {"\xc3\xbc\x62ung", "lbung"}, 1),
            std::vector<std::string>{"\xc3\xbc\x62ung"});
}

}  // namespace
}  // namespace agrid

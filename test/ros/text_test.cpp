// SPDX-License-Identifier: BSD-3-Clause
#include "ros/text.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace agrid_map_ros {
namespace {

TEST(Text, LeadingSlashOfAFrame) {
  EXPECT_EQ(withoutLeadingSlash("/map"), "map");
  EXPECT_EQ(withoutLeadingSlash("map"), "map");
  EXPECT_EQ(withoutLeadingSlash(""), "");
}

TEST(Text, Printable) {
  EXPECT_TRUE(
      isPrintable("K\xc3\xbc"
                  "che \xe5\x8e\xa8\xe6\x88\xbf"));
  EXPECT_FALSE(isPrintable("a\tb"));
  EXPECT_FALSE(
      isPrintable("\xc2\x9b"
                  "2J"));
}

TEST(Text, NumbersDoNotDependOnTheLocale) {
  EXPECT_EQ(formatNumber(0.25), "0.25");
  EXPECT_EQ(formatNumber(1e9), "1e+09");
}

/// The definition, without the table.
std::size_t slowDistance(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::string shorter_a = a.substr(1);
  const std::string shorter_b = b.substr(1);
  return std::min({slowDistance(shorter_a, shorter_b) + (a[0] == b[0] ? 0 : 1),
                   slowDistance(shorter_a, b) + 1, slowDistance(a, shorter_b) + 1});
}

TEST(Text, EditDistanceIsTheDefinitions) {
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    std::string a(random() % 6, 'a');
    std::string b(random() % 6, 'a');
    for (char& c : a) c = static_cast<char>('a' + random() % 3);
    for (char& c : b) c = static_cast<char>('a' + random() % 3);
    EXPECT_EQ(editDistance(a, b), slowDistance(a, b)) << a << " " << b;
  }
}

TEST(Text, ClosestNames) {
  EXPECT_EQ(closestNames("area_12", {"hall", "Area_1", "area_2", "area_2"}, 2),
            (std::vector<std::string>{"Area_1", "area_2"}));
  EXPECT_TRUE(closestNames("x", {}).empty());
}

}  // namespace
}  // namespace agrid_map_ros

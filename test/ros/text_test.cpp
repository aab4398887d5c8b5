// SPDX-License-Identifier: BSD-3-Clause
#include "ros/text.h"

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

}  // namespace
}  // namespace agrid_map_ros

// SPDX-License-Identifier: BSD-3-Clause
#include "tools/pairs_file.h"

#include <gtest/gtest.h>

#include "agrid/map/map_io.h"
#include "support/temporary_folder.h"

namespace agrid::tools {
namespace {

const char* const kHeader = "map,id,start_x_px,start_y_px,goal_x_px,goal_y_px,reachable\n";

TEST(ReadPairs, TakesItsColumnsByName) {
  const test::TemporaryFolder folder;
  const auto path = folder.write(
      "pairs.csv", std::string(kHeader) + "office,a-1,1,2,3.5,4,1\r\n\noffice,b,5,6,7,8,0\n");
  const auto pairs = readPairs(path);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].id, "a-1");
  EXPECT_EQ(pairs[0].start_px, Point2(1, 2));
  EXPECT_EQ(pairs[0].goal_px, Point2(3.5, 4));
  EXPECT_EQ(pairs[1].id, "b");
}

TEST(ReadPairs, TakesTheBestKnownLengthWhereThereIsOne) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("pairs.csv",
                                 "id,best_known_length_px,start_x_px,start_y_px,goal_x_px,goal_y_px"
                                 "\na,12.5,1,2,3,4\nb,,1,2,3,4\n");
  const auto pairs = readPairs(path);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].best_known_px, 12.5);
  EXPECT_FALSE(pairs[1].best_known_px);
}

TEST(ReadPairs, RefusesWhatItCannotReadAndNamesTheLine) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(readPairs(folder.path("missing.csv")), FileError);
  EXPECT_THROW(readPairs(folder.write("empty.csv", "")), FileError);
  for (const std::string bad :
       {"m,1,1,2,3\n", "m,1,1,2,three,4,1\n", "m,1,1,2,nan,4,1\n", "m,../x,1,2,3,4,1\n",
        "m,,1,2,3,4,1\n", "m,1,1,2,3,4,1\nm,1,1,2,3,4,1\n"}) {
    const auto path = folder.write("bad.csv", kHeader + bad);
    try {
      readPairs(path);
      ADD_FAILURE() << bad;
    } catch (const FileError& error) {
      const std::string line = bad.find("\nm") == std::string::npos ? ":2: " : ":3: ";
      EXPECT_NE(std::string(error.what()).find("bad.csv" + line), std::string::npos)
          << error.what();
    }
  }
  EXPECT_THROW(readPairs(folder.write("columns.csv", "id,start_x_px\n1,2\n")), FileError);
}

}  // namespace
}  // namespace agrid::tools

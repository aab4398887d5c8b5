// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "agrid/map/map_io.h"
#include "support/ascii_map.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

using test::asciiGrid;
using test::contentsOf;

std::size_t filesIn(const test::TemporaryFolder& folder) {
  const std::filesystem::directory_iterator files(folder.path());
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST(SaveMap, WritesWhatMapSaverWrites) {
  const test::TemporaryFolder folder;
  OccupancyGrid grid = asciiGrid({"#.?", "..."}, 0.05, {Point2(-1.5, 1e-7), 0});
  grid.values[0] = 25;
  grid.values[1] = 26;
  grid.values[2] = 65;
  saveMap(grid, folder.path("a b.yaml"));
  EXPECT_EQ(contentsOf(folder.path("a b.pgm")), "P5\n# CREATOR: agrid_map 0.05 m/pix\n3 2\n255\n" +
                                                    std::string("\0\xFE\xCD", 3) +
                                                    std::string("\xFE\xCD\0", 3));
  EXPECT_EQ(contentsOf(folder.path("a b.yaml")),
            "image: \"a b.pgm\"\nresolution: 0.05\norigin: [-1.5, 0.0000001, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_EQ(filesIn(folder), 2u);
}

TEST(SaveMap, ReplacesAMapAndLeavesNothingElse) {
  const test::TemporaryFolder folder;
  saveMap(asciiGrid({"#########"}), folder.path("m.yml"));
  saveMap(asciiGrid({"."}), folder.path("m.yml"));
  EXPECT_EQ(contentsOf(folder.path("m.pgm")).back(), '\xFE');
  EXPECT_EQ(filesIn(folder), 2u);
}

TEST(SaveMap, NameWithoutTheUsualEnding) {
  const test::TemporaryFolder folder;
  saveMap(asciiGrid({"."}), folder.path("v1.2"));
  EXPECT_TRUE(std::filesystem::exists(folder.path("v1.2.pgm")));
}

TEST(SaveMap, QuotesTheImageName) {
  const test::TemporaryFolder folder;
  saveMap(asciiGrid({"."}), folder.path("a\"b\\c #: .yaml"));
  const std::string yaml = contentsOf(folder.path("a\"b\\c #: .yaml"));
  EXPECT_EQ(yaml.substr(0, yaml.find('\n')), "image: \"a\\\"b\\\\c #: .pgm\"");
}

FileErrorCode codeOfSaving(const std::string& path) {
  try {
    saveMap(asciiGrid({"."}), path);
  } catch (const FileError& error) {
    return error.code();
  }
  ADD_FAILURE() << "saved";
  return FileErrorCode::kImage;
}

TEST(SaveMap, RefusesImpossiblePaths) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(codeOfSaving(folder.path("missing/m.yaml")), FileErrorCode::kPath);
  EXPECT_EQ(codeOfSaving(folder.path("a\nb.yaml")), FileErrorCode::kPath);
  EXPECT_EQ(codeOfSaving(folder.path(std::string("a\0b.yaml", 8))), FileErrorCode::kPath);
  EXPECT_EQ(codeOfSaving(folder.path(std::string(300, 'x'))), FileErrorCode::kPath);
  EXPECT_EQ(filesIn(folder), 0u);
}

TEST(SaveMap, AFolderInTheWayStaysAndNoTemporaryFileDoes) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("m.pgm"));
  EXPECT_EQ(codeOfSaving(folder.path("m.yaml")), FileErrorCode::kIo);
  EXPECT_EQ(filesIn(folder), 1u);
}

TEST(SaveMap, AWriteErrorLeavesTheOldMapAndNothingElse) {
  const test::TemporaryFolder folder;
  saveMap(asciiGrid({"#"}), folder.path("m.yaml"));
  const std::string before = contentsOf(folder.path("m.pgm"));
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlim_t old_limit = limit.rlim_cur;
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);  // else the limit ends the process
  limit.rlim_cur = 100;
  setrlimit(RLIMIT_FSIZE, &limit);
  FileErrorCode code = FileErrorCode::kPath;
  try {
    saveMap(asciiGrid({std::string(200, '.')}), folder.path("m.yaml"));
  } catch (const FileError& error) {
    code = error.code();
  }
  limit.rlim_cur = old_limit;
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(code, FileErrorCode::kIo);
  EXPECT_EQ(contentsOf(folder.path("m.pgm")), before);
  EXPECT_EQ(filesIn(folder), 2u);
}

TEST(SaveMap, RefusesAGridOfTheWrongSize) {
  const test::TemporaryFolder folder;
  OccupancyGrid grid = asciiGrid({"..."});
  grid.values.pop_back();
  EXPECT_THROW(saveMap(grid, folder.path("m.yaml")), MapError);
  EXPECT_THROW(saveMap(OccupancyGrid{}, folder.path("m.yaml")), MapError);
  EXPECT_EQ(filesIn(folder), 0u);
}

}  // namespace
}  // namespace agrid

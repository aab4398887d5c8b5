// SPDX-License-Identifier: BSD-3-Clause
#include "tools/output_directory.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "agrid/map/map_io.h"
#include "support/temporary_folder.h"
#include "tools/arguments.h"

namespace agrid::tools {
namespace {

using test::contentsOfFolder;
using test::TemporaryFolder;
using Files = std::map<std::string, std::string>;

TEST(OutputDirectory, AppearsWhenPublished) {
  const TemporaryFolder temp;
  {
    OutputDirectory output(temp / "out/", {"a", "b"}, false);
    writeText(output.stagedPath("a"), "1");
    writeText(output.stagedPath("b"), "2");
    EXPECT_FALSE(std::filesystem::exists(temp / "out"));
    output.publish();
  }
  EXPECT_EQ(contentsOfFolder(temp / "out"), (Files{{"a", "1"}, {"b", "2"}}));
  EXPECT_EQ(contentsOfFolder(temp / "").size(), 1U);
}

TEST(OutputDirectory, NewOneIsAsOpenAsOthers) {
  const TemporaryFolder temp;
  const mode_t mask = umask(022);
  OutputDirectory output(temp / "out", {}, false);
  output.publish();
  umask(mask);
  struct stat info {};
  ASSERT_EQ(stat((temp / "out").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777U, 0755U);
}

TEST(OutputDirectory, F28_UnfinishedOutputLeavesNoTrace) {
  const TemporaryFolder temp;
  std::filesystem::create_directory(temp / "there");
  for (const char* name : {"new", "there"}) {
    OutputDirectory output(temp / name, {"a"}, false);
    writeText(output.stagedPath("a"), "1");
  }
  EXPECT_EQ(contentsOfFolder(temp / ""), (Files{{"there", ""}}));
  EXPECT_TRUE(contentsOfFolder(temp / "there").empty());
}

TEST(OutputDirectory, F28_ExistingFilesNeedForce) {
  const TemporaryFolder temp;
  std::filesystem::create_directory(temp / "out");
  writeText(temp / "out/a", "old");
  writeText(temp / "out/other", "kept");
  EXPECT_THROW(OutputDirectory(temp / "out", {"a"}, false), UsageError);
  EXPECT_NO_THROW(OutputDirectory(temp / "out", {"b"}, false));
  OutputDirectory output(temp / "out", {"a"}, true);
  writeText(output.stagedPath("a"), "new");
  EXPECT_EQ(test::contentsOf(temp / "out/a"), "old");
  output.publish();
  EXPECT_EQ(test::contentsOf(temp / "out/a"), "new");
  EXPECT_EQ(test::contentsOf(temp / "out/other"), "kept");
}

TEST(OutputDirectory, F28_PlacesThatCannotBeWrittenAreRefusedAtOnce) {
  const TemporaryFolder temp;
  writeText(temp / "file", "");
  EXPECT_THROW(OutputDirectory(temp / "missing/out", {"a"}, false), FileError);
  EXPECT_THROW(OutputDirectory(temp / "file", {"a"}, false), FileError);
  EXPECT_THROW(OutputDirectory(temp / "file/out", {"a"}, false), FileError);
  EXPECT_THROW(OutputDirectory("", {"a"}, false), UsageError);
}

TEST(OutputDirectory, F28_ReadOnlyDirectoryIsRefused) {
  // /proc takes no directories, not even from root.
  EXPECT_THROW(
      {
        OutputDirectory output("/proc/agrid_map_output", {"a"}, false);
        writeText(output.stagedPath("a"), "1");
      },
      FileError);
}

TEST(OutputDirectory, FullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_THROW(writeText("/dev/full", "text"), FileError);
  EXPECT_THROW(writePng("/dev/full", cv::Mat::zeros(4, 4, CV_8UC1)), FileError);
}

}  // namespace
}  // namespace agrid::tools

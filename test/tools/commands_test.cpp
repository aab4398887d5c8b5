// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands.h"

#include <fstream>
#include <iostream>
#include <sstream>

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace agrid::tools {
namespace {

using test::TemporaryFolder;

/// What a run of the tool gave back.
struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

Outcome runTool(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "agrid_map_tool");
  std::ostringstream out;
  std::ostringstream err;
  std::streambuf* former_out = std::cout.rdbuf(out.rdbuf());
  std::streambuf* former_err = std::cerr.rdbuf(err.rdbuf());
  Outcome outcome;
  outcome.code = run(arguments);
  std::cout.rdbuf(former_out);
  std::cerr.rdbuf(former_err);
  outcome.out = out.str();
  outcome.err = err.str();
  return outcome;
}

TEST(Commands, HelpListsTheCommands) {
  const Outcome help = runTool({"--help"});
  EXPECT_EQ(help.code, kDone);
  EXPECT_NE(help.out.find("convert"), std::string::npos);
  EXPECT_NE(help.out.find("generate"), std::string::npos);
  EXPECT_EQ(help.err, "");
}

TEST(Commands, EveryCommandHasHelp) {
  for (const char* command : {"convert", "generate", "plan", "eval"}) {
    const Outcome help = runTool({command, "--help"});
    EXPECT_EQ(help.code, kDone);
    EXPECT_EQ(help.out.find(std::string("usage: agrid_map_tool ") + command), 0U);
  }
}

TEST(Commands, TellsItsVersion) {
  const Outcome version = runTool({"--version"});
  EXPECT_EQ(version.code, kDone);
  EXPECT_EQ(version.out.find("agrid_map_tool "), 0U);
  EXPECT_NE(version.out.find('.'), std::string::npos);
}

TEST(Commands, F28_WrongUsageGoesToStandardErrorWith64) {
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"paint"},
      {"--gloss"},
      {"convert"},
      {"convert", "map.yaml"},
      {"convert", "map.yaml", "-o"},
      {"convert", "map.yaml", "-o", "out", "--gloss"},
      {"convert", "map.yaml", "second.yaml", "-o", "out"},
      {"convert", "map.yaml", "-o", "out", "--param", "canny_low"},
      {"convert", "map.yaml", "-o", "out", "--param", "canny_low=wide"},
      {"convert", "map.yaml", "-o", "out", "--param", "cannylow=1"},
      {"convert", "map.yaml", "-o", "out", "--param", "max_threshold=1.5"},
      {"convert", "map.yaml", "-o", "out", "--method", "guess"},
      {"generate", "--size", "600"},
      {"generate", "-o", "out", "--size", "99"},
      {"generate", "-o", "out", "--size", "many"},
      {"generate", "-o", "out", "--seed", "-1"},
      {"generate", "-o", "out", "--no-noise=1"},
      {"eval"},
      {"eval", "maps", "--threads", "0"},
      {"eval", "maps", "--method", "guess"},
  };
  for (const auto& arguments : wrong) {
    const Outcome outcome = runTool(arguments);
    SCOPED_TRACE(outcome.err);
    EXPECT_EQ(outcome.code, kWrongUsage);
    EXPECT_NE(outcome.err.find("usage: agrid_map_tool"), std::string::npos);
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST(Commands, FilesThatCannotBeReadOrWrittenGive2) {
  const TemporaryFolder temp;
  EXPECT_EQ(runTool({"convert", temp / "none.yaml", "-o", temp / "out"}).code, kFileFailed);
  EXPECT_FALSE(std::filesystem::exists(temp / "out"));
  const Outcome outcome = runTool({"generate", "-o", temp / "none/out"});
  EXPECT_EQ(outcome.code, kFileFailed);
  EXPECT_NE(outcome.err.find(temp / "none"), std::string::npos);
}

TEST(Commands, F28_ClosedStandardOutputIsNoSuccess) {
  std::ofstream closed;
  std::ostringstream err;
  std::streambuf* former_out = std::cout.rdbuf(closed.rdbuf());
  std::streambuf* former_err = std::cerr.rdbuf(err.rdbuf());
  const int code = run({"agrid_map_tool", "--help"});
  std::cout.rdbuf(former_out);
  std::cerr.rdbuf(former_err);
  EXPECT_EQ(code, kFileFailed);
  EXPECT_NE(err.str().find("standard output"), std::string::npos);
  EXPECT_TRUE(std::cout.good());
}

}  // namespace
}  // namespace agrid::tools

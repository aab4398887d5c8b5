// SPDX-License-Identifier: BSD-3-Clause
#include "tools/pipeline_options.h"

#include <sstream>

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace agrid::tools {
namespace {

ConversionParams paramsOf(const std::vector<std::string>& words) {
  Syntax syntax;
  syntax.command = "convert";
  syntax.options = pipelineOptions();
  return conversionParams(Arguments(syntax, words));
}

TEST(PipelineOptions, EveryParameterIsDocumentedUnderItsName) {
  std::string message;
  try {
    paramsOf({"--param", "no_such=1"});
  } catch (const UsageError& error) {
    message = error.what();
  }
  const std::string lead = "there are ";
  ASSERT_NE(message.find(lead), std::string::npos) << message;
  const std::string document =
      test::contentsOf(std::string(AGRID_TEST_DATA) + "/../../doc/parameters.md");
  std::istringstream names(message.substr(message.find(lead) + lead.size()));
  int count = 0;
  for (std::string name; names >> name; ++count) {
    EXPECT_NE(document.find("| `" + name + "` |"), std::string::npos) << name;
  }
  EXPECT_GT(count, 20);
}

TEST(PipelineOptions, SetWhatTheyName) {
  const ConversionParams params = paramsOf(
      {"--param", "merge_ratio=0.5", "-p", "estimate_direction=false", "--method", "paper"});
  EXPECT_EQ(params.pipeline.areas.merge_ratio, 0.5);
  EXPECT_FALSE(params.pipeline.walls.estimate_direction);
  EXPECT_EQ(params.pipeline.areas.method, AreaMethod::kPaper);
}

}  // namespace
}  // namespace agrid::tools

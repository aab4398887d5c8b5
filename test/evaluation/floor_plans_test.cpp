// SPDX-License-Identifier: BSD-3-Clause
// Maps with rooms drawn by people, where they are present, scored as agrid_map_tool eval does.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "evaluation/mean_scores.h"
#include "tools/case_scoring.h"

namespace agrid {
namespace {

using tools::ConversionParams;
using tools::EvalCase;
using tools::EvalGroup;

constexpr int kThreads = 2;

class FloorPlans : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder : {"bormann", "real"}) {
      if (!std::filesystem::exists(path(folder))) GTEST_SKIP() << "no maps at " << path(folder);
    }
  }
  static std::string path(const std::string& folder) {
    return std::string(AGRID_SHARED) + "/maps/" + folder;
  }
  static std::vector<EvalCase> casesOf(const std::string& folder, EvalGroup group) {
    std::vector<EvalCase> cases = tools::findEvalCases(path(folder), "").cases;
    cases.erase(std::remove_if(cases.begin(), cases.end(),
                               [&](const EvalCase& one) { return one.group != group; }),
                cases.end());
    return cases;
  }
  static std::vector<tools::CaseScores> score(const std::vector<EvalCase>& cases,
                                              const ConversionParams& params = {}) {
    return tools::scoreCases(cases, params, tools::evalViews(false), kThreads);
  }
};

TEST_F(FloorPlans, PlainOnesScoreAsMeasured) {
  const auto cases = casesOf("bormann", EvalGroup::kPlain);
  ASSERT_EQ(cases.size(), 10U);
  test::expectAsMeasured(score(cases), test::kPlainPlans, RoomFloor::kAll);
}

TEST_F(FloorPlans, FurnishedOnesScoreAsMeasured) {
  const auto cases = casesOf("bormann", EvalGroup::kFurnished);
  ASSERT_EQ(cases.size(), 10U);
  test::expectAsMeasured(score(cases), test::kFurnishedPlans, RoomFloor::kFree);
}

TEST_F(FloorPlans, ThePapersMethodScoresAsMeasured) {
  ConversionParams params;
  params.pipeline.areas.method = AreaMethod::kPaper;
  test::expectAsMeasured(score(casesOf("bormann", EvalGroup::kPlain), params),
                         test::kPaperOnPlainPlans, RoomFloor::kAll);
}

TEST_F(FloorPlans, RealRobotsMapsScoreAsMeasured) {
  const auto cases = casesOf("real", EvalGroup::kFolder);
  ASSERT_EQ(cases.size(), 7U);
  test::expectAsMeasured(score(cases), test::kRealMaps, RoomFloor::kFree);
}

// test/data/truth holds rooms and doors only, and names them as the maps
TEST_F(FloorPlans, RealRobotsMapsWithRoomsDrawnByHandScoreAsMeasured) {
  const std::string truth = AGRID_TEST_DATA "/truth";
  std::vector<EvalCase> cases = tools::findEvalCases(path("real"), truth).cases;
  cases.erase(std::remove_if(cases.begin(), cases.end(),
                             [&](const EvalCase& one) { return one.rooms.rfind(truth, 0) != 0; }),
              cases.end());
  ASSERT_EQ(cases.size(), 3U);
  test::expectAsMeasured(score(cases), test::kHandDrawnRooms, RoomFloor::kFree);
}

TEST_F(FloorPlans, OtherViewsOfThemScoreAsMeasured) {
  std::vector<EvalCase> cases;
  for (const EvalGroup group : {EvalGroup::kPlain, EvalGroup::kFurnished}) {
    for (const EvalCase& one : casesOf("bormann", group)) {
      const bool chosen = one.name.rfind("lab_ipa", 0) == 0 ||
                          one.name.rfind("lab_d_scan", 0) == 0 ||
                          one.name.rfind("office_a", 0) == 0;
      if (chosen) cases.push_back(one);
    }
  }
  ASSERT_EQ(cases.size(), 6U);
  const auto views = tools::evalViews(true);
  test::expectFallsAsMeasured(tools::scoreCases(cases, {}, views, kThreads), views,
                              &test::MeasuredFall::plans);
}

}  // namespace
}  // namespace agrid

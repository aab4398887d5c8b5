// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/areas/area_cost.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "support/retagged_map.h"

namespace agrid {
namespace {

Properties cost(const std::string& value) { return {{"cost", value}}; }

TEST(AreaCost, AMetreCountsOneUnlessAPropertySaysMoreOrLess) {
  EXPECT_EQ(areaCost({}), 1);
  EXPECT_EQ(areaCost({{"floor", "7"}}), 1);
  EXPECT_EQ(areaCost(cost("2.5")), 2.5);
  EXPECT_EQ(areaCost(cost(" 5e-1 ")), 0.5);
  EXPECT_EQ(areaCost(cost("0.001")), 0.001);
  EXPECT_EQ(areaCost(cost("1000")), 1000);
}

TEST(AreaCost, ForbiddenAndInfAreInfinite) {
  for (const char* value : {"forbidden", "inf"}) {
    EXPECT_TRUE(std::isinf(areaCost(cost(value)))) << value;
    EXPECT_EQ(costProblem(cost(value)), "") << value;
  }
}

TEST(AreaCost, ABadOneCountsOneAndIsNamedWithItsBounds) {
  for (const char* value :
       {"", "0", "-1", "0.0009", "1001", "nan", "-inf", "2,5", "2 m", "Forbidden"}) {
    EXPECT_EQ(areaCost(cost(value)), 1) << value;
    const std::string problem = costProblem(cost(value));
    EXPECT_NE(problem.find("'" + std::string(value) + "'"), std::string::npos) << problem;
    EXPECT_NE(problem.find("from 0.001 to 1000"), std::string::npos) << problem;
  }
  EXPECT_LT(costProblem(cost(std::string(4096, 'x'))).size(), 200U);
  EXPECT_EQ(costProblem({}), "");
  EXPECT_EQ(costProblem(cost("3")), "");
}

TEST(AreaCost, AMapNamesTheAreaWhoseCostIsBad) {
  std::vector<std::string> rows(30, "#" + std::string(38, '.') + "#");
  rows.front() = rows.back() = std::string(40, '#');
  const SemanticMap map = annotate(test::structureOf(test::asciiMap(rows, 0.1)), {}, {});
  AreaTag tag = test::areaAtSeed(1, "hall", {2, 1.5});
  tag.properties = cost("much");
  const SemanticMap tagged = test::after(map, {PutTag{tag}});
  ASSERT_EQ(tagged.area_map.areas.size(), 1U);
  ASSERT_EQ(tagged.area_map.warnings.size(), map.area_map.warnings.size() + 1);
  EXPECT_EQ(tagged.area_map.warnings.back(),
            "area 'hall': cost 'much' must be a number from 0.001 to 1000 or 'forbidden'");
  tag.properties = cost("2");
  EXPECT_EQ(test::after(tagged, {PutTag{tag}}).area_map.warnings, map.area_map.warnings);
}

}  // namespace
}  // namespace agrid

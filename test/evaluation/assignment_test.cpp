// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/assignment.h"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace agrid {
namespace {

/// The least total cost over all ways to give each row its own column (rows <= columns).
double leastCostByTrial(const CostMatrix& cost) {
  std::vector<std::size_t> columns(cost.columns);
  std::iota(columns.begin(), columns.end(), 0U);
  double least = std::numeric_limits<double>::infinity();
  do {
    double sum = 0;
    for (std::size_t r = 0; r < cost.rows; ++r) sum += cost.at(r, columns[r]);
    least = std::min(least, sum);
  } while (std::next_permutation(columns.begin(), columns.end()));
  return least;
}

CostMatrix transpose(const CostMatrix& cost) {
  CostMatrix result{cost.columns, cost.rows, std::vector<double>(cost.values.size())};
  for (std::size_t r = 0; r < cost.rows; ++r) {
    for (std::size_t c = 0; c < cost.columns; ++c) result.at(c, r) = cost.at(r, c);
  }
  return result;
}

TEST(Assignment, CostsAsLittleAsTheBestOfAllWays) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    CostMatrix cost{1 + random() % 5, 0, {}};
    cost.columns = cost.rows + random() % 3;
    while (cost.values.size() < cost.rows * cost.columns) cost.values.push_back(value(random));
    for (const CostMatrix& matrix : {cost, transpose(cost)}) {
      const auto pairs = assignAtLeastCost(matrix);
      ASSERT_EQ(pairs.size(), cost.rows);
      double sum = 0;
      std::vector<bool> row_used(matrix.rows);
      std::vector<bool> column_used(matrix.columns);
      for (const auto& [r, c] : pairs) {
        EXPECT_FALSE(row_used[r] || column_used[c]);
        row_used[r] = column_used[c] = true;
        sum += matrix.at(r, c);
      }
      EXPECT_NEAR(sum, leastCostByTrial(cost), 1e-12);
    }
  }
}

TEST(Assignment, OfNothingIsEmpty) { EXPECT_TRUE(assignAtLeastCost({0, 3, {}}).empty()); }

}  // namespace
}  // namespace agrid

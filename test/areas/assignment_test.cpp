// SPDX-License-Identifier: BSD-3-Clause
#include "areas/assignment.h"

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

TEST(Assignment, OfNothingIsEmpty) {
  EXPECT_TRUE(assignAtLeastCost({0, 3, {}}).empty());
  EXPECT_TRUE(assignAtMostValue({}).empty());
}

TEST(Assignment, OfSomePairsIsWorthAsMuchAsOfAll) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(0.1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    CostMatrix cost{8, 9, std::vector<double>(72, 0)};
    std::vector<PairValue> candidates;
    for (std::size_t i = 0; i < 72; ++i) {
      if (random() % 4 != 0) continue;
      cost.values[i] = -value(random);
      candidates.push_back({i / 9, i % 9, -cost.values[i]});
    }
    double least = 0;
    for (const auto& [r, c] : assignAtLeastCost(cost)) least += cost.at(r, c);
    double sum = 0;
    std::vector<bool> row_used(8);
    std::vector<bool> column_used(9);
    for (const PairValue& pair : assignAtMostValue(candidates)) {
      EXPECT_FALSE(row_used[pair.row] || column_used[pair.column]);
      row_used[pair.row] = column_used[pair.column] = true;
      EXPECT_EQ(pair.value, -cost.at(pair.row, pair.column));
      sum += pair.value;
    }
    EXPECT_NEAR(sum, -least, 1e-12);
  }
}

TEST(Assignment, OfManySmallSetsIsQuick) {
  // As one set of 20000 rows and columns this would take hours and 3 GB.
  std::vector<PairValue> candidates;
  for (std::size_t i = 0; i < 20000; i += 2) {
    for (const std::size_t row : {i, i + 1}) {
      for (const std::size_t column : {i, i + 1}) {
        candidates.push_back({row, column, row == column ? 1.0 : 1.5});
      }
    }
  }
  const auto pairs = assignAtMostValue(candidates);
  EXPECT_EQ(pairs.size(), 20000U);
  EXPECT_TRUE(std::all_of(pairs.begin(), pairs.end(),
                          [](const PairValue& pair) { return pair.row != pair.column; }));
}

}  // namespace
}  // namespace agrid

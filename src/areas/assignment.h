// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace agrid {

/// A dense matrix, row-major.
struct CostMatrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;
  double& at(std::size_t r, std::size_t c) { return values[r * columns + c]; }
  double at(std::size_t r, std::size_t c) const { return values[r * columns + c]; }
};

/// Pairs rows with columns one to one, as many as there are of the fewer, at the least total cost
/// (Kuhn 1955, by shortest augmenting paths with potentials, O(n^2 m)).
/// @return (row, column), sorted by column if there are fewer rows, else by row
std::vector<std::pair<std::size_t, std::size_t>> assignAtLeastCost(const CostMatrix& cost);

/// What it is worth to pair a row with a column.
struct PairValue {
  std::size_t row = 0;
  std::size_t column = 0;
  double value = 0;  ///< positive
};

/// The pairs, one to one, whose values make the largest sum. Takes time by the largest set of rows
/// and columns that hang together, not by the number of all of them.
/// @param candidates  each row and column at most once together; all others are worth nothing
std::vector<PairValue> assignAtMostValue(const std::vector<PairValue>& candidates);

}  // namespace agrid

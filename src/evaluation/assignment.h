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

}  // namespace agrid

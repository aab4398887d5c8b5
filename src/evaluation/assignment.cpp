// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/assignment.h"

#include <algorithm>
#include <limits>

namespace agrid {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// State of the search; rows and columns count from 1, column 0 is where a path starts.
struct Matching {
  std::vector<double> row_potential;
  std::vector<double> column_potential;
  std::vector<std::size_t> row_of;  ///< for each column, 0 = none
};

/// Finds a partner for row `start` and moves the partners of others where that is cheaper.
void augment(const CostMatrix& cost, std::size_t start, Matching& m) {
  std::vector<double> slack(cost.columns + 1, kInfinite);
  std::vector<std::size_t> from(cost.columns + 1, 0);
  std::vector<bool> visited(cost.columns + 1, false);
  m.row_of[0] = start;
  std::size_t column = 0;
  do {
    visited[column] = true;
    const std::size_t row = m.row_of[column];
    double least = kInfinite;
    std::size_t next = 0;
    for (std::size_t c = 1; c <= cost.columns; ++c) {
      if (visited[c]) continue;
      const double reduced = cost.at(row - 1, c - 1) - m.row_potential[row] - m.column_potential[c];
      if (reduced < slack[c]) {
        slack[c] = reduced;
        from[c] = column;
      }
      if (slack[c] < least) {
        least = slack[c];
        next = c;
      }
    }
    for (std::size_t c = 0; c <= cost.columns; ++c) {
      if (visited[c]) {
        m.row_potential[m.row_of[c]] += least;
        m.column_potential[c] -= least;
      } else {
        slack[c] -= least;
      }
    }
    column = next;
  } while (m.row_of[column] != 0);
  for (; column != 0; column = from[column]) m.row_of[column] = m.row_of[from[column]];
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> assignAtLeastCost(const CostMatrix& cost) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  if (cost.rows > cost.columns) {
    CostMatrix transposed{cost.columns, cost.rows, std::vector<double>(cost.values.size())};
    for (std::size_t r = 0; r < cost.rows; ++r) {
      for (std::size_t c = 0; c < cost.columns; ++c) transposed.at(c, r) = cost.at(r, c);
    }
    for (const auto& [r, c] : assignAtLeastCost(transposed)) pairs.emplace_back(c, r);
    return pairs;
  }
  Matching m{std::vector<double>(cost.rows + 1, 0), std::vector<double>(cost.columns + 1, 0),
             std::vector<std::size_t>(cost.columns + 1, 0)};
  for (std::size_t r = 1; r <= cost.rows; ++r) augment(cost, r, m);
  for (std::size_t c = 1; c <= cost.columns; ++c) {
    if (m.row_of[c] != 0) pairs.emplace_back(m.row_of[c] - 1, c - 1);
  }
  return pairs;
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "areas/assignment.h"

#include <algorithm>
#include <limits>
#include <map>

#include "tags/disjoint_sets.h"

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

using Candidates = std::vector<PairValue>;

/// Numbers from 0 for numbers that occur.
class Numbering {
 public:
  std::size_t operator()(std::size_t known) {
    return numbers_.try_emplace(known, numbers_.size()).first->second;
  }
  std::size_t size() const { return numbers_.size(); }

 private:
  std::map<std::size_t, std::size_t> numbers_;
};

/// Candidates in sets that have no row and no column in common.
std::vector<Candidates> independentSets(const Candidates& candidates) {
  std::size_t rows = 0;
  std::size_t columns = 0;
  for (const PairValue& c : candidates) {
    rows = std::max(rows, c.row + 1);
    columns = std::max(columns, c.column + 1);
  }
  DisjointSets sets(rows + columns);
  const auto name = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
  for (const PairValue& c : candidates) sets.unite(name(c.row), name(rows + c.column));
  Numbering number;
  std::vector<Candidates> independent;
  for (const PairValue& c : candidates) {
    const std::size_t set = number(sets.find(name(c.row)));
    if (set == independent.size()) independent.emplace_back();
    independent[set].push_back(c);
  }
  return independent;
}

/// The best pairs of candidates that hang together.
void assignTogether(const Candidates& candidates, std::vector<PairValue>& pairs) {
  Numbering row;
  Numbering column;
  for (const PairValue& c : candidates) {
    row(c.row);
    column(c.column);
  }
  CostMatrix cost{row.size(), column.size(), std::vector<double>(row.size() * column.size(), 0)};
  for (const PairValue& c : candidates) cost.at(row(c.row), column(c.column)) = -c.value;
  std::vector<std::size_t> column_of(cost.rows, cost.columns);
  for (const auto& [r, c] : assignAtLeastCost(cost)) column_of[r] = c;
  for (const PairValue& c : candidates) {
    if (column_of[row(c.row)] == column(c.column)) pairs.push_back(c);
  }
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

std::vector<PairValue> assignAtMostValue(const std::vector<PairValue>& candidates) {
  std::vector<PairValue> pairs;
  for (const Candidates& set : independentSets(candidates)) assignTogether(set, pairs);
  return pairs;
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace agrid {

/// Sets that only ever grow together; `find` names a set by one of its members.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// Joins the set of `other` to that of `keeper`, whose name both bear from then on.
  void unite(std::uint32_t keeper, std::uint32_t other) { parent_[find(other)] = find(keeper); }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace agrid {

/// Sets that only ever grow together; `find` names a set by one of its members.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count = 0) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  /// A new member, alone in its set.
  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }
  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// Joins the set of `other` to that of `keeper`, whose name both bear from then on.
  void unite(std::uint32_t keeper, std::uint32_t other) { parent_[find(other)] = find(keeper); }
  /// For each member the number of its set, counted from 0 in the order of their first members,
  /// whatever the order of joining was.
  std::vector<std::uint32_t> numbers() {
    constexpr std::uint32_t kNone = 0xFFFFFFFF;
    std::vector<std::uint32_t> number_of_name(parent_.size(), kNone);
    std::vector<std::uint32_t> number(parent_.size());
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) {
      std::uint32_t& known = number_of_name[find(i)];
      if (known == kNone) known = next++;
      number[i] = known;
    }
    return number;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace agrid

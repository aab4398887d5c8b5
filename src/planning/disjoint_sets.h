// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace agrid::planning {

/// Sets that grow together; the root of a set is its lowest member, so that results do not depend
/// on the order of joining.
class DisjointSets {
 public:
  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }
  std::size_t size() const { return parent_.size(); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a < b) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
  }
  /// Consecutive numbers for the roots, in their order.
  std::vector<std::uint32_t> numbers() {
    std::vector<std::uint32_t> number(parent_.size());
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) {
      const std::uint32_t top = root(i);
      number[i] = top == i ? next++ : number[top];
    }
    return number;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace agrid::planning

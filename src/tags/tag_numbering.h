// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "agrid/tags/tag.h"

namespace agrid {

inline const Point2& placeOf(const AreaTag& tag) { return tag.seed_map; }
inline const Point2& placeOf(const DoorTag& tag) { return tag.pose_map.position; }

/// Adds proposals to `tags` as a reader meets them, from the top, then from the left, with the
/// lowest ids that `given` does not use.
template <typename T>
void addNumbered(std::vector<T> proposals, const std::vector<Tag>& given, std::vector<Tag>& tags) {
  std::stable_sort(proposals.begin(), proposals.end(), [](const T& a, const T& b) {
    const Point2& p = placeOf(a);
    const Point2& q = placeOf(b);
    return p.y() != q.y() ? p.y() > q.y() : p.x() < q.x();
  });
  using Id = decltype(T::id);
  std::set<Id> used;
  for (const Tag& tag : given) {
    if (const auto* same_kind = std::get_if<T>(&tag)) used.insert(same_kind->id);
  }
  std::uint32_t id = 0;
  for (T& proposal : proposals) {
    do {
      proposal.id = Id{++id};
    } while (used.count(proposal.id) > 0);
    tags.emplace_back(std::move(proposal));
  }
}

}  // namespace agrid

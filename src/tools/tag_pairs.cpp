// SPDX-License-Identifier: BSD-3-Clause
#include "tools/tag_pairs.h"

#include <algorithm>
#include <tuple>

#include "agrid/tags/name.h"

namespace agrid::tools {
namespace {

constexpr double kSameShare = 0.5;     // of the union, or of each of both
constexpr double kSameDistance = 0.6;  // [m], as far as a door may be moved to be known again

struct Candidate {
  double cost = 0;
  std::size_t a = 0;
  std::size_t b = 0;
};

TagPairs noPairs(std::size_t count_a, std::size_t count_b) {
  TagPairs pairs;
  pairs.in_b.resize(count_a);
  pairs.in_a.resize(count_b);
  return pairs;
}

/// The cheapest first, each tag once.
void take(std::vector<Candidate> candidates, TagPairs& pairs) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return std::tie(x.cost, x.a, x.b) < std::tie(y.cost, y.a, y.b);
  });
  for (const Candidate& candidate : candidates) {
    if (pairs.in_b[candidate.a] || pairs.in_a[candidate.b]) continue;
    pairs.in_b[candidate.a] = candidate.b;
    pairs.in_a[candidate.b] = candidate.a;
  }
}

template <typename T>
TagPairs pairsById(const std::vector<T>& a, const std::vector<T>& b) {
  TagPairs pairs = noPairs(a.size(), b.size());
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i].id == b[j].id) {
      pairs.in_b[i] = j;
      pairs.in_a[j] = i;
    }
    const bool a_is_behind = a[i].id <= b[j].id;
    if (b[j].id <= a[i].id) ++j;
    if (a_is_behind) ++i;
  }
  return pairs;
}

template <typename T>
bool sameName(const T& x, const T& y) {
  return !x.name.empty() && foldCase(x.name) == foldCase(y.name);
}

template <typename T>
double distance(const T& x, const T& y) {
  return (x.pose_map.position - y.pose_map.position).norm();
}

/// All pairs for which `fits` holds, by their distance.
template <typename T, typename Fits>
std::vector<Candidate> byDistance(const std::vector<T>& a, const std::vector<T>& b,
                                  const Fits& fits) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (fits(a[i], b[j])) candidates.push_back({distance(a[i], b[j]), i, j});
    }
  }
  return candidates;
}

template <typename T>
bool isNear(const T& x, const T& y) {
  return distance(x, y) <= kSameDistance;
}

/// Tags with a kind and id in common, and how many of them are alike.
struct Likeness {
  std::size_t common = 0;
  std::size_t alike = 0;

  void add(bool is_alike) {
    ++common;
    if (is_alike) ++alike;
  }
};

bool overlap(std::size_t i, std::size_t j, const std::vector<OutlineShare>& shares) {
  return std::any_of(shares.begin(), shares.end(), [&](const OutlineShare& share) {
    return share.a == i && share.b == j && std::max(share.of_a, share.of_b) >= kSameShare;
  });
}

bool idsMeanTheSame(const StoreContents& a, const StoreContents& b, const KnowledgePairs& by_id,
                    const std::vector<OutlineShare>& shares) {
  if (a.history != 0 && a.history == b.history) return true;
  const Knowledge& known_a = a.map.knowledge;
  const Knowledge& known_b = b.map.knowledge;
  Likeness likeness;
  for (std::size_t i = 0; i < known_a.areas.size(); ++i) {
    if (!by_id.areas.in_b[i]) continue;
    const AreaTag& x = known_a.areas[i];
    const AreaTag& y = known_b.areas[*by_id.areas.in_b[i]];
    const bool have_outlines = !x.outline_map.empty() && !y.outline_map.empty();
    likeness.add(have_outlines ? overlap(i, *by_id.areas.in_b[i], shares) : sameName(x, y));
  }
  const auto addPlaced = [&](const auto& tags_a, const auto& tags_b, const TagPairs& pairs) {
    for (std::size_t i = 0; i < tags_a.size(); ++i) {
      if (!pairs.in_b[i]) continue;
      const auto& other = tags_b[*pairs.in_b[i]];
      likeness.add(isNear(tags_a[i], other) || sameName(tags_a[i], other));
    }
  };
  addPlaced(known_a.doors, known_b.doors, by_id.doors);
  addPlaced(known_a.objects, known_b.objects, by_id.objects);
  return likeness.common > 0 && 2 * likeness.alike >= likeness.common;
}

TagPairs objectsByPlace(const std::vector<ObjectTag>& a, const std::vector<ObjectTag>& b,
                        bool same_frame) {
  TagPairs pairs = noPairs(a.size(), b.size());
  take(byDistance(a, b, sameName<ObjectTag>), pairs);
  if (same_frame) take(byDistance(a, b, isNear<ObjectTag>), pairs);
  return pairs;
}

}  // namespace

KnowledgePairs pairUp(const StoreContents& a, const StoreContents& b,
                      const std::vector<OutlineShare>& shares) {
  const Knowledge& known_a = a.map.knowledge;
  const Knowledge& known_b = b.map.knowledge;
  KnowledgePairs pairs{true, pairsById(known_a.areas, known_b.areas),
                       pairsById(known_a.doors, known_b.doors),
                       pairsById(known_a.objects, known_b.objects)};
  if (idsMeanTheSame(a, b, pairs, shares)) return pairs;
  const bool same_frame = a.map.frame_id == b.map.frame_id;
  pairs.by_id = false;
  pairs.areas = noPairs(known_a.areas.size(), known_b.areas.size());
  std::vector<Candidate> areas;
  for (const OutlineShare& share : shares) {
    if (share.overUnion() >= kSameShare) areas.push_back({-share.overUnion(), share.a, share.b});
  }
  take(areas, pairs.areas);
  pairs.doors = noPairs(known_a.doors.size(), known_b.doors.size());
  if (same_frame) take(byDistance(known_a.doors, known_b.doors, isNear<DoorTag>), pairs.doors);
  pairs.objects = objectsByPlace(known_a.objects, known_b.objects, same_frame);
  return pairs;
}

}  // namespace agrid::tools

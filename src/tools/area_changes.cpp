// SPDX-License-Identifier: BSD-3-Clause
#include "tools/area_changes.h"

#include <map>
#include <optional>
#include <string>

namespace agrid::tools {
namespace {

using Parts = std::vector<std::size_t>;

/// A part and what it may be a part of.
struct PartShare {
  std::size_t part = 0;
  std::size_t whole = 0;
  double of_part = 0;
  double of_whole = 0;
};

/// By whole: its parts, where there are two or more.
/// @param sames  of each part: which area it is among the wholes
std::map<std::size_t, Parts> dividedAreas(const std::vector<PartShare>& shares,
                                          const std::vector<std::optional<std::size_t>>& sames) {
  std::vector<std::optional<PartShare>> best(sames.size());
  for (const PartShare& share : shares) {
    if (share.of_part < 0.5) continue;
    std::optional<PartShare>& former = best[share.part];
    // the whole's surface is that of the part times of_part over of_whole
    const bool is_smaller =
        !former || share.of_part * former->of_whole < former->of_part * share.of_whole;
    if (is_smaller) former = share;
  }
  std::map<std::size_t, Parts> parts;
  for (std::size_t part = 0; part < sames.size(); ++part) {
    if (!best[part]) continue;
    if (!sames[part] || *sames[part] == best[part]->whole) parts[best[part]->whole].push_back(part);
  }
  for (auto whole = parts.begin(); whole != parts.end();) {
    whole = whole->second.size() < 2 ? parts.erase(whole) : std::next(whole);
  }
  return parts;
}

std::string listed(const Parts& parts, const std::vector<AreaTag>& areas) {
  std::vector<std::string> names;
  for (const std::size_t part : parts) names.push_back(numbered(areas[part]));
  return "areas " + enumerated(names);
}

}  // namespace

ToldAreas tellSplitsAndMerges(const std::vector<AreaTag>& a, const std::vector<AreaTag>& b,
                              const std::vector<OutlineShare>& shares, const TagPairs& pairs,
                              Sentences& sentences) {
  std::vector<PartShare> b_in_a;
  std::vector<PartShare> a_in_b;
  for (const OutlineShare& share : shares) {
    b_in_a.push_back({share.b, share.a, share.of_b, share.of_a});
    a_in_b.push_back({share.a, share.b, share.of_a, share.of_b});
  }
  ToldAreas told;
  for (const auto& [whole, parts] : dividedAreas(b_in_a, pairs.in_a)) {
    sentences.say(a[whole], "was split into " + listed(parts, b));
    told.a.insert(whole);
    told.b.insert(parts.begin(), parts.end());
  }
  for (const auto& [whole, parts] : dividedAreas(a_in_b, pairs.in_b)) {
    sentences.addOn(b[whole], listed(parts, a) + " were merged into " + described(b[whole]));
    told.b.insert(whole);
    told.a.insert(parts.begin(), parts.end());
  }
  return told;
}

}  // namespace agrid::tools

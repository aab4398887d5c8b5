// SPDX-License-Identifier: BSD-3-Clause
#include "identity/area_recognition.h"

#include <set>
#include <string>

#include "identity/area_matching.h"
#include "identity/tag_words.h"

namespace agrid {
namespace {

std::vector<AreaClaim> claimsOf(const FramedKnowledge& known) {
  std::vector<AreaClaim> claims;
  for (const AreaTag& tag : known.live.areas) claims.push_back({tag, false});
  for (const Tag& tag : known.waiting) {
    if (const auto* area = std::get_if<AreaTag>(&tag)) claims.push_back({*area, true});
  }
  return claims;
}

bool isGiven(const AreaTag& tag) { return tag.source != TagSource::kAutomatic; }

/// The tag as it is on the new map. A point that a person named stays while it lies in the area.
AreaTag placed(AreaTag tag, std::size_t index, const SemanticMap& fresh) {
  const Area& area = fresh.area_map.areas[index];
  const MapGeometry& geometry = fresh.map().geometry();
  const auto pixel = geometry.pixelAt(tag.seed_map);
  const bool holds_seed = pixel && fresh.area_map.pixel_labels[geometry.index(*pixel)] == index + 1;
  if (!isGiven(tag) || !holds_seed) tag.seed_map = area.anchor_map;
  tag.outline_map = area.outline_map;
  return tag;
}

AreaTag newTag(AreaId id) {
  AreaTag tag;
  tag.id = id;
  tag.name = "area_" + std::to_string(static_cast<std::uint32_t>(id));
  return tag;
}

}  // namespace

std::vector<AreaId> placeAreas(const FramedKnowledge& known, const SemanticMap& fresh,
                               const RecognitionParams& params, Recognition& result) {
  const std::vector<AreaClaim> claims = claimsOf(known);
  const AreaMatches matches = matchAreas(claims, fresh.area_map, fresh.map().geometry(), params);
  std::set<std::string> names;
  for (const AreaClaim& claim : claims) names.insert(claim.tag.name);
  for (std::size_t c = 0; c < claims.size(); ++c) {
    const AreaClaim& claim = claims[c];
    const std::string& doubt = matches.doubt[c];
    if (doubt.empty()) {
      if (claim.waits) result.report.push_back(words(claim.tag) + " is back");
    } else if (isGiven(claim.tag)) {
      wait(claim.tag, claim.waits, known.frame_id, doubt, result);
    } else {
      result.report.push_back(words(claim.tag) + " is gone: " + doubt);
    }
  }
  std::vector<AreaId> ids;
  for (std::size_t i = 0; i < fresh.area_map.areas.size(); ++i) {
    const auto& claim = matches.claim_of_area[i];
    const AreaTag tag = claim
                            ? claims[*claim].tag
                            : newTag(newId<AreaId>(result.knowledge.next_ids.area, "area_", names));
    apply(PutTag{placed(tag, i, fresh)}, result.knowledge);
    ids.push_back(tag.id);
  }
  return ids;
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "identity/area_matching.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "areas/assignment.h"
#include "identity/outline_overlap.h"
#include "identity/polygon_lookup.h"

namespace agrid {
namespace {

std::string percent(double share) {
  return std::to_string(static_cast<int>(std::lround(share * 100))) + " %";
}

double share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/// How like an area a claim is, or why it is none.
struct Judgement {
  double likeness = 0;  ///< (0, 1]
  std::string doubt;
};

class Matcher {
 public:
  Matcher(const std::vector<AreaClaim>& claims, const AreaMap& fresh, const MapGeometry& geometry,
          const RecognitionParams& params)
      : claims_(claims),
        fresh_(fresh),
        geometry_(geometry),
        params_(params),
        overlap_(placesOf(claims), geometry, fresh.pixel_labels.vector(), fresh.areas.size()) {}

  AreaMatches match() const {
    AreaMatches matches{std::vector<std::optional<std::size_t>>(fresh_.areas.size()),
                        std::vector<std::optional<std::size_t>>(claims_.size()),
                        std::vector<std::string>(claims_.size())};
    std::vector<PairValue> candidates;
    for (std::size_t c = 0; c < claims_.size(); ++c) {
      matches.doubt[c] = claims_[c].tag.outline_map.empty() ? judgeSeed(c, candidates)
                                                            : judgeOutline(c, candidates);
    }
    for (const PairValue& pair : assignAtMostValue(candidates)) {
      matches.claim_of_area[pair.column] = pair.row;
      matches.area_of_claim[pair.row] = pair.column;
      matches.doubt[pair.row].clear();
    }
    return matches;
  }

 private:
  static std::vector<FormerPlace> placesOf(const std::vector<AreaClaim>& claims) {
    std::vector<FormerPlace> places;
    for (const AreaClaim& claim : claims) places.push_back({claim.tag.outline_map, claim.waits});
    return places;
  }

  /// More than any likeness: of two claims to an area the one of higher rank has it.
  static double rankOf(const AreaClaim& claim) {
    const bool given = claim.tag.source != TagSource::kAutomatic;
    return (given ? 4 : 0) + (claim.waits ? 0 : 2);
  }

  std::size_t areaAtSeed(const AreaTag& tag) const {
    const auto pixel = geometry_.pixelAt(tag.seed_map);
    return pixel ? fresh_.pixel_labels[geometry_.index(*pixel)] : std::size_t{0};
  }

  // Both add what a claim may be, and return why it may turn out to be nothing.

  std::string judgeSeed(std::size_t c, std::vector<PairValue>& candidates) const {
    const std::size_t label = areaAtSeed(claims_[c].tag);
    if (label == 0) return "it lies in no area";
    // of several the first
    candidates.push_back({c, label - 1, rankOf(claims_[c]) + 1.0 / (2.0 + static_cast<double>(c))});
    return "its place is known by another name";
  }

  std::string judgeOutline(std::size_t c, std::vector<PairValue>& candidates) const {
    if (overlap_.visible[c] < params_.min_visible) return "its place is not on the map";
    std::string doubt = "there is no area at its place";
    std::int64_t most = 0;
    for (const OutlineOverlap::Common& common : overlap_.of_place[c]) {
      const Judgement judged = judge(c, common);
      if (judged.doubt.empty()) {
        candidates.push_back({c, common.area - 1, judged.likeness + rankOf(claims_[c])});
      }
      if (common.pixels <= most) continue;
      most = common.pixels;
      doubt = judged.doubt.empty() ? "its place is known by another name" : judged.doubt;
    }
    return doubt;
  }

  Judgement judge(std::size_t c, const OutlineOverlap::Common& common) const {
    const AreaClaim& claim = claims_[c];
    const bool given = claim.tag.source != TagSource::kAutomatic;
    const double min_share = !given        ? params_.min_share
                             : claim.waits ? params_.min_return_share
                                           : params_.min_given_share;
    const std::int64_t smaller = std::min(overlap_.place_size[c], overlap_.area_size[common.area]);
    if (share(common.pixels, smaller) < params_.min_containment) {
      return {0, "there is hardly an area at its place"};
    }
    const double of_claim = share(common.pixels, sizeWithout(c, common.area));
    if (of_claim < min_share) {
      return {0, "its place is divided, at most " + percent(of_claim) + " of it are one area"};
    }
    const auto& known = claim.waits ? overlap_.ever_known : overlap_.known;
    const double of_area = share(common.pixels, known[common.area]);
    if (of_area < min_share) {
      return {0, "its place is only a part of an area, " + percent(of_area) +
                     " of what is known of it"};
    }
    const std::size_t at_seed = areaAtSeed(claim.tag);
    if (given && at_seed != 0 && at_seed != common.area) {
      return {0, "most of its place is one area, the point that was named lies in another"};
    }
    return {of_claim * of_area, ""};
  }

  /// The pixels of a claim in areas; if it waits, without the rooms that the area is a ring around:
  /// they lie in its outline but were never its own.
  std::int64_t sizeWithout(std::size_t c, std::size_t area) const {
    std::int64_t size = 0;
    const Polygon& outline = fresh_.areas[area - 1].outline_map;
    for (const auto& [other, pixels] : overlap_.of_place[c]) {
      const bool enclosed = claims_[c].waits && other != area &&
                            contains(outline, fresh_.areas[other - 1].anchor_map);
      if (!enclosed) size += pixels;
    }
    return size;
  }

  const std::vector<AreaClaim>& claims_;
  const AreaMap& fresh_;
  const MapGeometry& geometry_;
  const RecognitionParams& params_;
  OutlineOverlap overlap_;
};

}  // namespace

AreaMatches matchAreas(const std::vector<AreaClaim>& claims, const AreaMap& fresh,
                       const MapGeometry& geometry, const RecognitionParams& params) {
  return Matcher(claims, fresh, geometry, params).match();
}

}  // namespace agrid

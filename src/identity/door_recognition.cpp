// SPDX-License-Identifier: BSD-3-Clause
#include "identity/door_recognition.h"

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "identity/door_matching.h"
#include "identity/polygon_lookup.h"
#include "identity/tag_words.h"

namespace agrid {
namespace {

using Sides = std::array<AreaId, 2>;

constexpr double kPi = 3.14159265358979323846;
/// How far beside the middle of a door one looks for the area there [m].
constexpr std::array<double, 3> kBeside{0.2, 0.4, 0.8};

bool isGiven(const DoorTag& tag) { return tag.source != TagSource::kAutomatic; }

std::vector<DoorClaim> claimsOf(const FramedKnowledge& known) {
  std::vector<DoorClaim> claims;
  for (const DoorTag& tag : known.live.doors) claims.push_back({tag, false});
  for (const Tag& tag : known.waiting) {
    if (const auto* door = std::get_if<DoorTag>(&tag)) claims.push_back({*door, true});
  }
  return claims;
}

/// The smallest former area that holds a point.
AreaId formerAreaAt(const Point2& point, const OutlineIndex& outlines, const Knowledge& known) {
  const auto found = outlines.smallestAt(point);
  return found ? known.areas[*found].id : AreaId{0};
}

Sides formerAreasBeside(const DoorTag& tag, const OutlineIndex& outlines, const Knowledge& known) {
  Sides sides{};
  for (const double beside : kBeside) {
    for (std::size_t side = 0; side < 2; ++side) {
      const Point2 point = tag.pose_map * Point2(side == 0 ? beside : -beside, 0);
      if (sides[side] == AreaId{0}) sides[side] = formerAreaAt(point, outlines, known);
    }
  }
  return sides;
}

/// Whether there is an area where a tag says that there is no door.
bool hasPlace(const DoorTag& tag, const SemanticMap& fresh) {
  const MapGeometry& geometry = fresh.map().geometry();
  for (const double beside : {0.0, 0.2, -0.2, 0.4, -0.4}) {
    const auto pixel = geometry.pixelAt(tag.pose_map * Point2(beside, 0));
    if (pixel && fresh.area_map.pixel_labels[geometry.index(*pixel)] != 0) return true;
  }
  return false;
}

/// An automatic door is where it is found, leading the way that it led before.
DoorTag placed(DoorTag tag, const Door& door, bool found_by_tag) {
  if (found_by_tag) return tag;
  DoorPlace place = placeOf(door);
  const bool turned = std::cos(place.pose_map.yaw - tag.pose_map.yaw) < 0;
  if (turned) place.pose_map.yaw = std::remainder(place.pose_map.yaw + kPi, 2 * kPi);
  tag.pose_map = place.pose_map;
  tag.width = place.width;
  return tag;
}

DoorTag newTag(DoorId id, const Door& door) {
  DoorTag tag;
  tag.id = id;
  tag.name = "door_" + std::to_string(static_cast<std::uint32_t>(id));
  tag.pose_map = placeOf(door).pose_map;
  return tag;
}

class DoorPlacement {
 public:
  DoorPlacement(const FramedKnowledge& known, const SemanticMap& fresh,
                const RecognitionParams& params, Recognition& result)
      : known_(known), fresh_(fresh), params_(params), result_(result), claims_(claimsOf(known)) {}

  void place(const std::vector<AreaId>& area_ids) {
    const auto& doors = fresh_.area_map.doors;
    const DoorMatches matches =
        matchDoors(claims_, formerAreas(), doors, freshAreas(area_ids), params_);
    for (std::size_t c = 0; c < claims_.size(); ++c) placeClaim(claims_[c], matches.doubt[c]);
    std::set<std::string> names;
    for (const DoorClaim& claim : claims_) names.insert(claim.tag.name);
    for (std::size_t d = 0; d < doors.size(); ++d) {
      const auto& claim = matches.claim_of_door[d];
      const DoorTag tag =
          claim ? claims_[*claim].tag
                : newTag(newId<DoorId>(result_.knowledge.next_ids.door, "door_", names), doors[d]);
      const bool found_by_tag = claim && isGiven(tag) && doors[d].id == tag.id;
      apply(PutTag{placed(tag, doors[d], found_by_tag)}, result_.knowledge);
    }
  }

 private:
  std::vector<Sides> formerAreas() const {
    const OutlineIndex outlines(known_.live.areas);
    std::vector<Sides> areas;
    for (const DoorClaim& claim : claims_) {
      areas.push_back(formerAreasBeside(claim.tag, outlines, known_.live));
    }
    return areas;
  }

  std::vector<Sides> freshAreas(const std::vector<AreaId>& area_ids) const {
    std::map<AreaId, AreaId> id_of{{AreaId{0}, AreaId{0}}};
    for (std::size_t i = 0; i < area_ids.size(); ++i) {
      id_of[fresh_.area_map.areas[i].id] = area_ids[i];
    }
    std::vector<Sides> areas;
    for (const Door& door : fresh_.area_map.doors) {
      areas.push_back({id_of[door.areas[0]], id_of[door.areas[1]]});
    }
    return areas;
  }

  void placeClaim(const DoorClaim& claim, const std::string& doubt) {
    const bool back = claim.tag.absent ? hasPlace(claim.tag, fresh_) : doubt.empty();
    if (back) {
      if (claim.tag.absent) apply(PutTag{claim.tag}, result_.knowledge);
      if (claim.waits) result_.report.push_back(words(claim.tag) + " is back");
    } else if (claim.tag.absent || isGiven(claim.tag)) {
      const std::string reason = claim.tag.absent ? "there is no area at its place" : doubt;
      wait(claim.tag, claim.waits, known_.frame_id, reason, result_);
    } else {
      result_.report.push_back(words(claim.tag) + " is gone: " + doubt);
    }
  }

  const FramedKnowledge& known_;
  const SemanticMap& fresh_;
  const RecognitionParams& params_;
  Recognition& result_;
  std::vector<DoorClaim> claims_;
};

}  // namespace

void placeDoors(const FramedKnowledge& known, const SemanticMap& fresh,
                const std::vector<AreaId>& area_ids, const RecognitionParams& params,
                Recognition& result) {
  DoorPlacement(known, fresh, params, result).place(area_ids);
}

}  // namespace agrid

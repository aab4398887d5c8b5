// SPDX-License-Identifier: BSD-3-Clause
#include "identity/door_matching.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "areas/assignment.h"

namespace agrid {
namespace {

/// A door so many times farther away than another is not taken for it, however near both are.
constexpr double kSureRatio = 3;
constexpr double kPi = 3.14159265358979323846;

struct Candidate {
  std::size_t claim = 0;
  std::size_t door = 0;
  double distance = 0;  ///< [m]
  double cost = 0;      ///< the distance, and more the less the areas beside them agree [m]
};

bool isGiven(TagSource source) { return source != TagSource::kAutomatic; }

/// Between two lines through doors, [0, pi/2].
double turnBetween(double a, double b) { return std::abs(std::remainder(a - b, kPi)); }

int commonAreas(const std::array<AreaId, 2>& a, const std::array<AreaId, 2>& b) {
  const auto same = [](AreaId x, AreaId y) { return x == y && x != AreaId{0} ? 1 : 0; };
  return std::max(same(a[0], b[0]) + same(a[1], b[1]), same(a[0], b[1]) + same(a[1], b[0]));
}

class DoorMatcher {
 public:
  DoorMatcher(const std::vector<DoorClaim>& claims,
              const std::vector<std::array<AreaId, 2>>& former_areas,
              const std::vector<Door>& doors, const std::vector<std::array<AreaId, 2>>& fresh_areas,
              const RecognitionParams& params)
      : claims_(claims),
        former_areas_(former_areas),
        doors_(doors),
        fresh_areas_(fresh_areas),
        params_(params),
        taken_(claims.size(), false),
        matches_{std::vector<std::optional<std::size_t>>(doors.size()),
                 std::vector<std::string>(claims.size(), "there is no door at its place")} {
    for (const Door& door : doors) places_.push_back(placeOf(door));
  }

  DoorMatches match() {
    matchGiven();
    std::vector<Candidate> candidates = findCandidates();
    std::vector<PairValue> sure;
    for (const Candidate& c : candidates) {
      if (isSure(c, candidates)) {
        sure.push_back({c.claim, c.door, value(c)});
      } else {
        matches_.doubt[c.claim] = "several doors may be the one";
      }
    }
    for (const PairValue& pair : assignAtMostValue(sure)) accept(pair.row, pair.column);
    return matches_;
  }

 private:
  void accept(std::size_t claim, std::size_t door) {
    matches_.claim_of_door[door] = claim;
    matches_.doubt[claim].clear();
    taken_[claim] = true;
  }

  /// The new map was annotated with given doors: they are there under their ids.
  void matchGiven() {
    std::map<DoorId, std::size_t> given;
    for (std::size_t c = 0; c < claims_.size(); ++c) {
      if (isGiven(claims_[c].tag.source)) given[claims_[c].tag.id] = c;
    }
    for (std::size_t d = 0; d < doors_.size(); ++d) {
      const auto claim = isGiven(doors_[d].source) ? given.find(doors_[d].id) : given.end();
      if (claim != given.end()) accept(claim->second, d);
    }
  }

  double reach(double width) const {
    return std::max(params_.max_door_shift, params_.max_door_shift_ratio * width);
  }

  std::vector<Candidate> findCandidates() const {
    std::vector<Candidate> candidates;
    for (std::size_t c = 0; c < claims_.size(); ++c) {
      const DoorTag& tag = claims_[c].tag;
      if (tag.absent || taken_[c]) continue;
      for (std::size_t d = 0; d < doors_.size(); ++d) {
        if (matches_.claim_of_door[d]) continue;
        const DoorPlace& place = places_[d];
        const double distance = (place.pose_map.position - tag.pose_map.position).norm();
        if (!(distance <= reach(std::max(tag.width, place.width)))) continue;
        const double turn_deg = turnBetween(place.pose_map.yaw, tag.pose_map.yaw) * 180 / kPi;
        if (turn_deg > params_.max_door_turn_deg) continue;
        const int common = commonAreas(former_areas_[c], fresh_areas_[d]);
        candidates.push_back({c, d, distance, distance + (2 - common) * params_.min_door_lead / 2});
      }
    }
    return candidates;
  }

  /// Whether no other candidate of its claim or of its door is about as near.
  bool isSure(const Candidate& mine, const std::vector<Candidate>& all) const {
    return std::none_of(all.begin(), all.end(), [&](const Candidate& other) {
      const bool same_claim = other.claim == mine.claim;
      const bool same_door = other.door == mine.door;
      if (same_claim == same_door) return false;
      // a given door has precedence over an automatic one, as well as one that doesn't wait
      if (same_door && rankOf(other.claim) < rankOf(mine.claim)) return false;
      const bool behind = other.distance > kSureRatio * mine.distance;
      return other.cost < mine.cost + params_.min_door_lead && !behind;
    });
  }

  int rankOf(std::size_t c) const {
    return (isGiven(claims_[c].tag.source) ? 2 : 0) + (claims_[c].waits ? 0 : 1);
  }
  double value(const Candidate& c) const { return 1 / (1 + c.cost); }

  const std::vector<DoorClaim>& claims_;
  const std::vector<std::array<AreaId, 2>>& former_areas_;
  const std::vector<Door>& doors_;
  const std::vector<std::array<AreaId, 2>>& fresh_areas_;
  const RecognitionParams& params_;
  std::vector<DoorPlace> places_;
  std::vector<bool> taken_;
  DoorMatches matches_;
};

}  // namespace

DoorPlace placeOf(const Door& door) {
  const Point2 along = door.jambs_map.b - door.jambs_map.a;
  const double yaw = std::atan2(along.y(), along.x()) + kPi / 2;
  return {{door.jambs_map.midpoint(), std::remainder(yaw, 2 * kPi)}, door.width};
}

DoorMatches matchDoors(const std::vector<DoorClaim>& claims,
                       const std::vector<std::array<AreaId, 2>>& former_areas,
                       const std::vector<Door>& doors,
                       const std::vector<std::array<AreaId, 2>>& fresh_areas,
                       const RecognitionParams& params) {
  return DoorMatcher(claims, former_areas, doors, fresh_areas, params).match();
}

}  // namespace agrid

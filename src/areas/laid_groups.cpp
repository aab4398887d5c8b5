// SPDX-License-Identifier: BSD-3-Clause
#include "areas/laid_groups.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace agrid {
namespace {

/// What tells groups apart at a glance.
std::pair<std::uint16_t, Point2> keyOf(const AreaGroup& group) {
  return {group.members.empty() ? std::uint16_t{0} : group.members.front(), group.seed_map};
}

struct ByKey {
  bool operator()(const AreaGroup* a, const AreaGroup* b) const {
    const auto [label, seed] = keyOf(*a);
    const auto [other_label, other_seed] = keyOf(*b);
    return std::make_tuple(label, seed.x(), seed.y()) <
           std::make_tuple(other_label, other_seed.x(), other_seed.y());
  }
};

bool isOneAutomaticArea(const AreaGroup& group) {
  return group.members.size() == 1 && group.doors.empty();
}

}  // namespace

LaidGroups::LaidGroups(const OccupancyMap& map, const AutomaticAreas& automatic,
                       const Grouping& grouping, const FormerTags* former)
    : geometry_(map.geometry()), automatic_(automatic), grouping_(grouping), former_(former) {
  std::set<const AreaGroup*, ByKey> before;
  if (former) {
    for (const AreaGroup& group : former->groups) before.insert(&group);
    const auto& areas = former->area_map.areas;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      former_area_.emplace(static_cast<std::uint32_t>(areas[i].id), i);
    }
  }
  for (const AreaGroup& group : grouping.groups) {
    LaidGroup laid;
    laid.group = group;
    const auto same = before.find(&group);
    if (!group.members.empty() && same != before.end() && partedAlike(**same, group)) {
      laid.former = *same;
      laid.group.jambs_map = laid.former->jambs_map;
      laid.group.slots = laid.former->slots;
      laid.seats.resize(laid.former->areas.size());
    } else if (isOneAutomaticArea(group)) {
      laid.seats.resize(1);
    } else {
      laid.parts = partsOf(group, map, automatic);
      laid.group.jambs_map = laid.parts->jambs_map;
      laid.seats.resize(laid.parts->parts.size());
    }
    groups_.push_back(std::move(laid));
  }
}

void LaidGroups::seat(const std::vector<AreaTag>& tags) {
  for (const bool automatic : {false, true}) {
    for (const AreaTag& tag : tags) {
      if ((tag.source == TagSource::kAutomatic) != automatic) continue;
      const auto place = placeOf(tag.seed_map);
      if (!place) continue;
      const AreaTag*& seat = groups_[place->group].seats[place->part];
      if (seat == nullptr) seat = &tag;
    }
  }
}

const Area& LaidGroups::shapeOf(const LaidGroup& group, std::size_t part) const {
  if (group.parts) return group.parts->parts[part];
  if (group.isAutomatic()) return automatic_.area_map.areas[group.group.members.front() - 1U];
  const auto id = static_cast<std::uint32_t>(group.former->areas[part]);
  return former_->area_map.areas[former_area_.at(id)];
}

std::optional<LaidGroups::Place> LaidGroups::placeOf(const Point2& seed_map) const {
  const auto pixel = geometry_.pixelAt(seed_map);
  if (!pixel) return std::nullopt;
  const std::size_t label = automatic_.area_map.pixel_labels[geometry_.index(*pixel)];
  if (label != 0) {
    const std::size_t group = grouping_.group_of[label - 1];
    const auto part = partAt(groups_[group], *pixel);
    return part ? std::optional<Place>({group, *part}) : std::nullopt;
  }
  for (std::size_t group = groups_.size(); group-- > 0;) {
    if (!groups_[group].group.members.empty()) break;  // islands come last
    if (const auto part = partAt(groups_[group], *pixel)) return Place{group, *part};
  }
  return std::nullopt;
}

std::optional<std::size_t> LaidGroups::partAt(const LaidGroup& group, Pixel pixel) const {
  if (group.isAutomatic() || (group.parts && group.parts->part_of.empty())) return 0;
  if (group.parts) {
    const cv::Point p(pixel.x, pixel.y);
    if (!group.parts->window.contains(p)) return std::nullopt;
    const int part = group.parts->part_of(p - group.parts->window.tl());
    return part == 0 ? std::nullopt
                     : std::optional<std::size_t>(static_cast<std::size_t>(part - 1));
  }
  const std::uint16_t label = former_->area_map.pixel_labels[geometry_.index(pixel)];
  if (label == 0) return std::nullopt;
  const auto& ids = group.former->areas;
  const auto found = std::find(ids.begin(), ids.end(), former_->area_map.areas[label - 1U].id);
  return found == ids.end()
             ? std::nullopt
             : std::optional<std::size_t>(static_cast<std::size_t>(found - ids.begin()));
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/areas/laid_tags.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "agrid/areas/area_cost.h"
#include "areas/area_groups.h"
#include "areas/label_painter.h"
#include "areas/laid_cells.h"
#include "areas/laid_doors.h"
#include "areas/laid_groups.h"
#include "tags/default_name.h"

namespace agrid {
namespace {

/// Why a given area tag sits nowhere, for a person.
std::string whyNoSeat(const AreaTag& tag, const OccupancyMap& map) {
  const auto pixel = map.geometry().pixelAt(tag.seed_map);
  if (!pixel) return "it lies outside the map";
  switch (map.at(*pixel)) {
    case Occupancy::kOccupied:
      return "it lies in an obstacle";
    case Occupancy::kUnknown:
      return "it lies in unknown space";
    case Occupancy::kFree:
      break;
  }
  return "another area tag given by a person has the area that it lies in";
}

/// Gives every part a tag, and puts those given tags that have no part aside.
/// @return the tags of each group's parts
SeatedTags fillSeats(const LaidGroups& laid, const OccupancyMap& map, Knowledge& known) {
  std::set<AreaId> seated;
  std::set<std::string> names;
  for (const AreaTag& tag : known.areas) names.insert(tag.name);
  SeatedTags tags;
  for (const LaidGroup& group : laid.groups()) {
    tags.emplace_back();
    for (std::size_t part = 0; part < group.seats.size(); ++part) {
      const Area& shape = laid.shapeOf(group, part);
      AreaTag tag;
      if (group.seats[part] != nullptr) {
        tag = *group.seats[part];
      } else {
        tag.id = AreaId{known.next_ids.area++};
        tag.seed_map = shape.anchor_map;
      }
      if (tag.name.empty()) {
        tag.name = defaultName("area", static_cast<std::uint32_t>(tag.id), names);
      }
      tag.outline_map = shape.outline_map;
      seated.insert(tag.id);
      tags.back().push_back(std::move(tag));
    }
  }
  std::vector<AreaTag> standing;
  standing.swap(known.areas);
  for (AreaTag& tag : standing) {
    if (tag.source == TagSource::kAutomatic || seated.count(tag.id) > 0) continue;
    const std::string reason = whyNoSeat(tag, map);
    apply(DeferTag{{std::move(tag), {}, reason}}, known);
  }
  for (const auto& of_group : tags) {
    known.areas.insert(known.areas.end(), of_group.begin(), of_group.end());
  }
  std::sort(known.areas.begin(), known.areas.end(),
            [](const AreaTag& a, const AreaTag& b) { return a.id < b.id; });
  return tags;
}

Area areaOf(const Area& shape, const AreaTag& tag) {
  Area area = shape;
  area.id = tag.id;
  area.name = tag.name;
  area.category = tag.category;
  area.source = tag.source;
  area.properties = tag.properties;
  return area;
}

std::vector<Area> describe(const LaidGroups& laid, const SeatedTags& tags) {
  std::vector<Area> areas;
  for (std::size_t g = 0; g < tags.size(); ++g) {
    for (std::size_t part = 0; part < tags[g].size(); ++part) {
      areas.push_back(areaOf(laid.shapeOf(laid.groups()[g], part), tags[g][part]));
    }
  }
  std::sort(areas.begin(), areas.end(), [](const Area& a, const Area& b) { return a.id < b.id; });
  return areas;
}

std::vector<AreaGroup> groupsWithAreas(const LaidGroups& laid, const SeatedTags& tags) {
  std::vector<AreaGroup> groups;
  for (std::size_t g = 0; g < tags.size(); ++g) {
    groups.push_back(laid.groups()[g].group);
    groups.back().areas.clear();
    for (const AreaTag& tag : tags[g]) groups.back().areas.push_back(tag.id);
  }
  return groups;
}

}  // namespace

LaidTags layTags(const OccupancyMap& map, const AGrid& grid, const AutomaticAreas& automatic,
                 const FormerTags* former, Knowledge known) {
  const Grouping grouping = groupAreas(map, automatic, known);
  LaidGroups laid(map, automatic, grouping, former);
  laid.seat(known.areas);
  const auto tags = fillSeats(laid, map, known);
  LaidTags result;
  AreaMap& area_map = result.area_map;
  area_map.warnings = automatic.area_map.warnings;
  area_map.areas = describe(laid, tags);
  for (std::string& warning : costWarnings(area_map.areas)) {
    area_map.warnings.push_back(std::move(warning));
  }
  area_map.pixel_labels = LabelPainter(map, automatic, former, area_map.areas).paint(laid, tags);
  result.groups = groupsWithAreas(laid, tags);
  const LaidAreas areas{area_map.areas, area_map.pixel_labels, result.groups};
  area_map.doors = layDoors(map, grid, automatic, grouping, areas, known);
  area_map.cell_areas = LaidCells(map, grid, automatic, former).label(laid, tags, area_map);
  result.knowledge = std::move(known);
  return result;
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/areas/laid_tags.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "areas/area_groups.h"
#include "areas/cell_labels.h"
#include "areas/laid_doors.h"
#include "areas/laid_groups.h"

namespace agrid {
namespace {

std::uint32_t number(AreaId id) { return static_cast<std::uint32_t>(id); }

/// Names that nobody has yet, made from an id.
class DefaultNames {
 public:
  explicit DefaultNames(const std::vector<AreaTag>& tags) {
    for (const AreaTag& tag : tags) used_.insert(tag.name);
  }
  std::string nameOf(AreaId id) {
    std::string name = "area_" + std::to_string(number(id));
    while (!used_.insert(name).second) name += "_";
    return name;
  }

 private:
  std::set<std::string> used_;
};

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
std::vector<std::vector<AreaTag>> fillSeats(const LaidGroups& laid, const OccupancyMap& map,
                                            Knowledge& known) {
  std::set<AreaId> seated;
  DefaultNames names(known.areas);
  std::vector<std::vector<AreaTag>> tags;
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
      if (tag.name.empty()) tag.name = names.nameOf(tag.id);
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

std::vector<Area> describe(const LaidGroups& laid, const std::vector<std::vector<AreaTag>>& tags) {
  std::vector<Area> areas;
  for (std::size_t g = 0; g < tags.size(); ++g) {
    for (std::size_t part = 0; part < tags[g].size(); ++part) {
      areas.push_back(areaOf(laid.shapeOf(laid.groups()[g], part), tags[g][part]));
    }
  }
  std::sort(areas.begin(), areas.end(), [](const Area& a, const Area& b) { return a.id < b.id; });
  return areas;
}

/// Labels of the areas from labels of before.
class Painter {
 public:
  Painter(const MapGeometry& geometry, const AutomaticAreas& automatic,
          const std::vector<Area>& areas)
      : geometry_(geometry), automatic_(automatic) {
    for (std::size_t i = 0; i < areas.size(); ++i) {
      label_of_.emplace(number(areas[i].id), static_cast<std::uint16_t>(i + 1));
    }
  }

  /// The labels after all that changed is painted over; the same ones if nothing did.
  PixelLabels paint(const LaidGroups& laid, const std::vector<std::vector<AreaTag>>& tags,
                    const AreaMap* former) {
    const AreaMap& base = former ? *former : automatic_.area_map;
    std::vector<std::uint16_t> new_label(base.areas.size() + 1, 0);
    bool painted = false;
    for (std::size_t g = 0; g < tags.size(); ++g) {
      const LaidGroup& group = laid.groups()[g];
      painted = painted || group.parts || (former && group.isAutomatic());
      if (group.parts || (former && group.isAutomatic())) continue;
      for (std::size_t part = 0; part < tags[g].size(); ++part) {
        const std::size_t label =
            former ? indexOf(base, group.former->areas[part]) + 1 : group.group.members.front();
        new_label[label] = label_of_.at(number(tags[g][part].id));
      }
    }
    bool same = !painted;
    for (std::size_t i = 0; i < new_label.size(); ++i) same = same && new_label[i] == i;
    if (same) return base.pixel_labels;
    std::vector<std::uint16_t> labels(base.pixel_labels.size());
    std::transform(base.pixel_labels.begin(), base.pixel_labels.end(), labels.begin(),
                   [&](std::uint16_t label) { return new_label[label]; });
    for (std::size_t g = 0; g < tags.size(); ++g) {
      const LaidGroup& group = laid.groups()[g];
      if (group.parts) paintParts(*group.parts, tags[g], labels);
      if (former && group.isAutomatic()) {
        paintAutomatic(group.group.members.front(), tags[g].front(), labels);
      }
    }
    return labels;
  }

 private:
  static std::size_t indexOf(const AreaMap& areas, AreaId id) {
    const auto found = std::lower_bound(areas.areas.begin(), areas.areas.end(), id,
                                        [](const Area& area, AreaId i) { return area.id < i; });
    return static_cast<std::size_t>(found - areas.areas.begin());
  }
  void paintParts(const GroupParts& parts, const std::vector<AreaTag>& tags,
                  std::vector<std::uint16_t>& labels) const {
    for (int y = 0; y < parts.window.height; ++y) {
      std::uint16_t* row = &labels[geometry_.index({parts.window.x, parts.window.y + y})];
      for (int x = 0; x < parts.window.width; ++x) {
        const int part = parts.part_of(y, x);
        if (part != 0) row[x] = label_of_.at(number(tags[static_cast<std::size_t>(part - 1)].id));
      }
    }
  }
  void paintAutomatic(std::uint16_t automatic_label, const AreaTag& tag,
                      std::vector<std::uint16_t>& labels) const {
    const cv::Rect& box = automatic_.boxes[automatic_label - 1U];
    const std::uint16_t label = label_of_.at(number(tag.id));
    for (int y = box.y; y < box.br().y; ++y) {
      for (int x = box.x; x < box.br().x; ++x) {
        const std::size_t i = geometry_.index({x, y});
        if (automatic_.area_map.pixel_labels[i] == automatic_label) labels[i] = label;
      }
    }
  }

  const MapGeometry& geometry_;
  const AutomaticAreas& automatic_;
  std::unordered_map<std::uint32_t, std::uint16_t> label_of_;
};

std::vector<AreaGroup> groupsWithAreas(const LaidGroups& laid,
                                       const std::vector<std::vector<AreaTag>>& tags) {
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
  Painter painter(map.geometry(), automatic, area_map.areas);
  area_map.pixel_labels = painter.paint(laid, tags, former ? &former->area_map : nullptr);
  result.groups = groupsWithAreas(laid, tags);
  const LaidAreas areas{area_map.areas, area_map.pixel_labels, result.groups};
  area_map.doors = layDoors(map, grid, automatic, grouping, areas, known);
  area_map.cell_areas = labelCells(grid, map.geometry(), area_map.pixel_labels, area_map.areas);
  result.knowledge = std::move(known);
  return result;
}

}  // namespace agrid

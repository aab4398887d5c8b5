// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "pipeline/edit_decisions.h"
#include "pipeline/edit_names.h"

namespace agrid {
namespace {

constexpr double kFreeReach = 5;  // how far from an obstacle a free point is looked for [m]
constexpr const char* kUnseen = "its place is unknown space; it waits until the map shows it";

/// The centre of the free pixel nearest to a pixel, as far as is looked for one.
std::optional<Point2> nearestFree(const OccupancyMap& map, Pixel from) {
  const MapGeometry& geometry = map.geometry();
  const int reach = static_cast<int>(kFreeReach / geometry.resolution);
  double best = static_cast<double>(reach) * reach;
  std::optional<Pixel> nearest;
  for (int ring = 1; ring <= reach && static_cast<double>(ring) * ring <= best; ++ring) {
    for (int y = from.y - ring; y <= from.y + ring; ++y) {
      const bool whole_row = std::abs(y - from.y) == ring;
      for (int x = from.x - ring; x <= from.x + ring; x += whole_row ? 1 : 2 * ring) {
        const double squared = std::pow(x - from.x, 2) + std::pow(y - from.y, 2);
        if (!geometry.contains({x, y}) || !map.isFree({x, y}) || squared > best) continue;
        if (nearest && squared == best) continue;
        best = squared;
        nearest = Pixel{x, y};
      }
    }
  }
  if (!nearest) return std::nullopt;
  return geometry.center(*nearest);
}

/// Where an area tag's point lies.
struct AreaPlace {
  const AreaTag* holder = nullptr;  ///< of the area that holds the point
  bool is_unknown = false;
};

AreaPlace findPlace(const Point2& seed_map, const EditScope& scope) {
  const Pixel pixel = requireInside(scope, seed_map);
  const OccupancyMap& map = scope.map.map();
  if (map.at(pixel) == Occupancy::kOccupied) {
    const auto free = nearestFree(map, pixel);
    refuse(EditErrorCode::kOutside,
           inWords(seed_map) + " lies in an obstacle; " +
               (free ? "the nearest free point is " + inWords(*free)
                     : "nothing is free within " + inWords(kFreeReach) + " m"));
  }
  if (map.at(pixel) == Occupancy::kUnknown) {
    if (scope.params.allow_unknown) return {nullptr, true};
    refuse(EditErrorCode::kOutside, inWords(seed_map) + " lies in unknown space");
  }
  const Area* area = areaAt(scope.map, seed_map);
  return {area ? findTag(scope.known(), area->id) : nullptr};
}

AreaTag withTexts(AreaTag tag, const AreaTag& said, bool by_name) {
  if (!said.category.empty()) tag.category = said.category;
  tag.properties = merged(std::move(tag.properties), said.properties);
  tag.name = newName(tag.name, tag.properties, said.name, by_name);
  return tag;
}

/// Names the area that holds the point.
Edit nameArea(const AddTag& request, const AreaTag& said, const AreaTag& holder,
              const EditScope& scope) {
  const bool is_given = holder.source != TagSource::kAutomatic;
  const bool same_name = said.name.empty() || isCalled(holder.name, holder.properties, said.name);
  if (is_given && !same_name && !request.replace && said.id != holder.id) {
    refuse(EditErrorCode::kNameTaken,
           "this is " + called(holder) + " already; rename it by its id or with replace");
  }
  Decision decision;
  AreaTag tag = withTexts(holder, said, said.id == AreaId{0} && same_name);
  // the first seed of an area that is named again is as good, so that saying it twice changes
  // nothing
  if (!is_given || !same_name || said.id == holder.id) tag.seed_map = said.seed_map;
  decision.message = "names the area at " + inWords(said.seed_map);
  if (is_given && tag.name != holder.name) decision.message += ", which was '" + holder.name + "'";
  decision.tag = std::move(tag);
  return conclude(std::move(decision), KnownTag{holder}, said.source, scope);
}

/// Puts a known or a new tag where nobody sits, or in the place of another.
Edit seatArea(const AddTag& request, const AreaTag& said, const Subject& subject,
              const AreaPlace& place, const EditScope& scope) {
  Decision decision;
  AreaTag tag = said;
  if (subject.known) {
    tag = withTexts(std::get<AreaTag>(subject.known->tag), said, subject.by_name);
    if (tag.seed_map != said.seed_map) tag.outline_map.clear();
    tag.seed_map = said.seed_map;
  } else {
    tag.properties = merged({}, said.properties);
    tag.outline_map.clear();
  }
  decision.message = (subject.known ? "is now at " : "a new area at ") + inWords(said.seed_map);
  if (place.holder && place.holder->source == TagSource::kAutomatic) {
    decision.before.emplace_back(
        DropTag{TagKind::kArea, static_cast<std::uint32_t>(place.holder->id)});
  } else if (place.holder) {
    if (!request.replace) {
      refuse(EditErrorCode::kNameTaken, inWords(said.seed_map) + " is in " + called(*place.holder) +
                                            "; replace puts it there");
    }
    const std::string reason = called(tag) + " was put in its place";
    decision.before.emplace_back(DeferTag{{*place.holder, {}, reason}});
    decision.message += "; " + called(*place.holder) + " waits, as " + reason;
  }
  if (place.is_unknown) {
    decision.waits_because = kUnseen;
    decision.message = kUnseen;
  }
  decision.tag = std::move(tag);
  return conclude(std::move(decision), subject.known, said.source, scope);
}

/// Changes what is said of an area, but not where it is.
Edit changeArea(const AreaTag& said, const KnownTag& known, const EditScope& scope) {
  Decision decision;
  decision.tag = withTexts(std::get<AreaTag>(known.tag), said, false);
  decision.message = "is changed";
  if (known.pending) decision.waits_because = known.pending->reason;
  return conclude(std::move(decision), known, said.source, scope);
}

/// A tag without a name that waits already where it was said.
std::optional<KnownTag> findWaiting(const Point2& seed_map, const EditScope& scope) {
  for (const PendingTag& pending : scope.known().pending) {
    const auto* area = std::get_if<AreaTag>(&pending.tag);
    if (area && area->seed_map == seed_map) return KnownTag{pending.tag, &pending};
  }
  return std::nullopt;
}

}  // namespace

Edit decideArea(const AddTag& request, const AreaTag& given, const EditScope& scope) {
  AreaTag said = given;
  if (said.source == TagSource::kAutomatic) said.source = TagSource::kManual;
  Subject subject = findSubject(request, scope);
  if (request.placement == Placement::kUnchanged) return changeArea(said, *subject.known, scope);
  requireFinite(said.seed_map, 0);
  const AreaPlace place = findPlace(said.seed_map, scope);
  const bool is_there =
      place.holder && (!subject.known ||
                       (!subject.known->pending &&
                        idOf(subject.known->tag) == static_cast<std::uint32_t>(place.holder->id)));
  if (is_there) return nameArea(request, said, *place.holder, scope);
  if (!subject.known && said.name.empty()) subject.known = findWaiting(said.seed_map, scope);
  if (subject.by_name && !request.replace &&
      !(std::get<AreaTag>(subject.known->tag).seed_map == said.seed_map)) {
    refuse(EditErrorCode::kNameTaken, "'" + said.name + "' is what " + called(subject.known->tag) +
                                          " is called; replace moves it here");
  }
  return seatArea(request, said, subject, place, scope);
}

}  // namespace agrid

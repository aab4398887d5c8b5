// SPDX-License-Identifier: BSD-3-Clause
#include "planning/endpoints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace agrid::planning {
namespace {

std::string describe(const MapGeometry& geometry, const Obstacles& obstacles, const FreeSpace& free,
                     Pixel p) {
  std::ostringstream text;
  if (obstacles.at(geometry.index(p))) {
    text << "lies in an obstacle, a closed door or unknown space";
  } else if (p.x == 0 || p.y == 0 || p.x == geometry.width - 1 || p.y == geometry.height - 1) {
    text << "lies on the edge of the map";
  } else {
    text << "is " << std::sqrt(free.squaredDistance(p)) * geometry.resolution
         << " m from the nearest obstacle, which is too close for a radius of "
         << free.radiusPx() * geometry.resolution << " m";
  }
  return text.str();
}

Endpoint endpointAt(const RadiusLevel& level, FinePoint point) {
  Endpoint end;
  end.point = point;
  const PortalGraph& regions = level.roadmap.regions();
  end.region = regions.nodeAt(level.free.geometry().index(point.pixel()));
  end.component = regions.componentOf(end.region);
  return end;
}

/// For each component its pixel nearest to `wanted` within `reach_px`.
std::vector<Endpoint> nearbyPlaces(const RadiusLevel& level, const Point2& wanted, Pixel middle,
                                   double reach_px) {
  const MapGeometry& geometry = level.free.geometry();
  const double largest = geometry.width + geometry.height;
  const int reach = static_cast<int>(std::ceil(std::min(reach_px, largest)));
  std::map<std::uint32_t, Endpoint> nearest;
  for (int y = std::max(middle.y - reach, 0); y <= std::min(middle.y + reach, geometry.height - 1);
       ++y) {
    for (int x = std::max(middle.x - reach, 0); x <= std::min(middle.x + reach, geometry.width - 1);
         ++x) {
      const double shift = (Point2(x, y) - wanted).norm();
      if (shift > reach_px || !level.free.isFree({x, y})) continue;
      Endpoint place = endpointAt(level, centerOf({x, y}));
      place.moved = true;
      place.shift_px = shift;
      const auto found = nearest.find(place.component);
      if (found == nearest.end() || shift < found->second.shift_px) {
        nearest[place.component] = place;
      }
    }
  }
  std::vector<Endpoint> places;
  for (const auto& entry : nearest) places.push_back(entry.second);
  std::stable_sort(places.begin(), places.end(),
                   [](const Endpoint& a, const Endpoint& b) { return a.shift_px < b.shift_px; });
  return places;
}

}  // namespace

EndpointChoice chooseEndpoints(const RadiusLevel& level, const Obstacles& obstacles,
                               const Point2& point_map, double tolerance) {
  const MapGeometry& geometry = level.free.geometry();
  EndpointChoice choice;
  if (!point_map.allFinite()) {
    choice.problem = "is not finite";
    return choice;
  }
  const auto pixel = geometry.pixelAt(point_map);
  if (!pixel) {
    choice.problem = "lies outside the map";
    return choice;
  }
  const Point2 wanted = pixelCoordinates(geometry, point_map);
  if (level.free.isFree(*pixel)) {
    choice.places = {endpointAt(level, insidePixel(*pixel, finePoint(wanted)))};
    return choice;
  }
  if (tolerance > 0) {
    choice.places = nearbyPlaces(level, wanted, *pixel, tolerance / geometry.resolution);
  }
  if (choice.places.empty()) {
    choice.problem = describe(geometry, obstacles, level.free, *pixel);
    if (tolerance > 0) choice.problem += ", and no free place lies within the tolerance";
  }
  return choice;
}

std::optional<std::pair<Endpoint, Endpoint>> connectedPair(const EndpointChoice& start,
                                                           const EndpointChoice& goal) {
  std::optional<std::pair<Endpoint, Endpoint>> best;
  for (const Endpoint& a : start.places) {
    for (const Endpoint& b : goal.places) {
      if (a.component != b.component) continue;
      if (best && a.shift_px + b.shift_px >= best->first.shift_px + best->second.shift_px) continue;
      best = {a, b};
    }
  }
  return best;
}

Target areaTarget(const RadiusLevel& level, std::uint16_t label) {
  Target target;
  target.label = label;
  const RegionLabels& labels = level.regionLabels();
  for (std::uint32_t region = 0; region < level.roadmap.regions().nodeCount(); ++region) {
    if (labels.labelOf(region) != label || labels.partsOf(region)) continue;
    target.regions.push_back(region);
    target.box = merged(target.box, level.roadmap.regions().boxOf(region));
  }
  for (const auto& [region, parts] : labels.parts()) {
    const auto box = parts->boxes.find(label);
    if (box == parts->boxes.end()) continue;
    target.parts.push_back({region, parts});
    target.box = merged(target.box, box->second);
  }
  return target;
}

std::set<std::uint32_t> componentsOf(const Target& target, const PortalGraph& regions) {
  std::set<std::uint32_t> components;
  for (const std::uint32_t region : target.regions) components.insert(regions.componentOf(region));
  for (const TargetPart& part : target.parts) components.insert(regions.componentOf(part.region));
  return components;
}

Target reachablePart(Target target, const PortalGraph& regions, std::uint32_t component) {
  target.regions.erase(std::remove_if(target.regions.begin(), target.regions.end(),
                                      [&](std::uint32_t region) {
                                        return regions.componentOf(region) != component;
                                      }),
                       target.regions.end());
  target.parts.erase(std::remove_if(target.parts.begin(), target.parts.end(),
                                    [&](const TargetPart& part) {
                                      return regions.componentOf(part.region) != component;
                                    }),
                     target.parts.end());
  return target;
}

}  // namespace agrid::planning

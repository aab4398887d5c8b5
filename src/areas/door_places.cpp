// SPDX-License-Identifier: BSD-3-Clause
#include "areas/door_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace agrid {
namespace {

constexpr double kSamePlace = 0.15;  // [m]
constexpr double kReach = 1.0;       // how far from a door its areas are looked for [m]
constexpr int kBarrierPx = 2;        // a barrier's own pixels go to either side

/// Image frame, in pixels.
Point2 inPixels(const MapGeometry& geometry, const Point2& point_map) {
  return inverse(geometry.map_from_image) * point_map / geometry.resolution;
}

std::optional<std::size_t> pixelIndex(const MapGeometry& geometry, const Point2& point_px) {
  const Pixel p{static_cast<int>(std::floor(point_px.x())),
                static_cast<int>(std::floor(point_px.y()))};
  if (!geometry.contains(p)) return std::nullopt;
  return geometry.index(p);
}

/// Points on a door a pixel apart, and the direction that leads through it.
struct Samples {
  std::vector<Point2> points_px;
  Point2 through = Point2::Zero();
};

Samples samplesOf(const Segment& jambs_map, const MapGeometry& geometry) {
  const Point2 a = inPixels(geometry, jambs_map.a);
  const Point2 b = inPixels(geometry, jambs_map.b);
  const double length = (b - a).norm();
  const int count = std::max(1, static_cast<int>(length));
  Samples samples;
  for (int i = 0; i < count; ++i) samples.points_px.push_back(a + (b - a) * ((i + 0.5) / count));
  if (length > 0) samples.through = Point2((b - a).y(), -(b - a).x()) / length;
  return samples;
}

bool leadSameWay(double yaw, double other) {
  return std::abs(std::cos(yaw - other)) > std::sqrt(0.5);
}

}  // namespace

DoorTag tagOf(const Door& door) {
  DoorTag tag;
  tag.id = door.id;
  tag.name = door.name;
  tag.pose_map = poseOf(door);
  tag.width = door.width;
  tag.state = door.state;
  tag.source = door.source;
  tag.properties = door.properties;
  return tag;
}

std::optional<DoorFit> fitOf(const DoorTag& tag, const Door& door, double resolution) {
  const double reach = std::max(kSamePlace, 2 * resolution);
  const Segment& jambs = door.jambs_map;
  const double from_middle = (jambs.midpoint() - tag.pose_map.position).norm();
  if (from_middle > reach) {
    const Point2 along = jambs.b - jambs.a;
    const double share = (tag.pose_map.position - jambs.a).dot(along) / along.squaredNorm();
    if (!(share >= 0 && share <= 1)) return std::nullopt;
    const Point2 foot = jambs.a + along * share;
    if ((foot - tag.pose_map.position).norm() > reach) return std::nullopt;
  }
  // last, for it costs most and few doors are near
  if (!leadSameWay(tag.pose_map.yaw, poseOf(door).yaw)) return std::nullopt;
  return DoorFit{from_middle > reach, from_middle};
}

std::vector<std::optional<std::size_t>> doorsMeant(const std::vector<const DoorTag*>& tags,
                                                   const std::vector<Door>& doors,
                                                   double resolution) {
  double reach = std::max(kSamePlace, 2 * resolution);
  std::multimap<double, std::size_t> by_x;
  for (std::size_t d = 0; d < doors.size(); ++d) {
    by_x.emplace(doors[d].jambs_map.midpoint().x(), d);
    reach = std::max(reach, doors[d].jambs_map.length());
  }
  // automatic, beside the middle, distance, tag, door: the better the smaller
  std::vector<std::tuple<bool, bool, double, std::size_t, std::size_t>> pairs;
  for (std::size_t t = 0; t < tags.size(); ++t) {
    const double x = tags[t]->pose_map.position.x();
    const auto end = by_x.upper_bound(x + reach);
    for (auto i = by_x.lower_bound(x - reach); i != end; ++i) {
      const auto fit = fitOf(*tags[t], doors[i->second], resolution);
      if (!fit) continue;
      pairs.emplace_back(tags[t]->source == TagSource::kAutomatic, fit->beside_middle,
                         fit->distance, t, i->second);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::optional<std::size_t>> meant(tags.size());
  std::set<std::size_t> taken;
  for (const auto& [automatic, beside, distance, tag, door] : pairs) {
    if (meant[tag] || !taken.insert(door).second) continue;
    meant[tag] = door;
  }
  return meant;
}

std::array<std::uint16_t, 2> DoorSides::beside(const Segment& jambs_map) const {
  const Samples samples = samplesOf(jambs_map, geometry_);
  const int reach = kBarrierPx + static_cast<int>(kReach / geometry_.resolution);
  std::array<std::map<std::uint16_t, int>, 2> seen;
  for (const Point2& point : samples.points_px) {
    for (const int side : {0, 1}) {
      for (int step = kBarrierPx; step <= reach; ++step) {
        const auto i = pixelIndex(geometry_, point + samples.through * (side == 0 ? -step : step));
        if (!i) break;
        if (labels_[*i] == 0) continue;
        ++seen[static_cast<std::size_t>(side)][labels_[*i]];
        break;
      }
    }
  }
  std::array<std::uint16_t, 2> result{};
  for (const std::size_t side : {0U, 1U}) {
    const auto most =
        std::max_element(seen[side].begin(), seen[side].end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != seen[side].end()) result[side] = most->first;
  }
  return result;
}

std::vector<DoorStretch> DoorSides::along(const Segment& jambs_map, const PixelLabels& automatic,
                                          const std::array<std::uint16_t, 2>& sides) const {
  const Samples samples = samplesOf(jambs_map, geometry_);
  const int reach = static_cast<int>(kReach / geometry_.resolution);
  // the nearest pixel of an automatic area, on whichever side it is here
  const auto labelNow = [&](const Point2& point, std::uint16_t side) -> std::uint16_t {
    for (int step = 0; step <= reach; ++step) {
      for (const int sign : {1, -1}) {
        const auto i = pixelIndex(geometry_, point + samples.through * (sign * step));
        if (i && automatic[*i] == side && labels_[*i] != 0) return labels_[*i];
      }
    }
    return 0;
  };
  std::vector<DoorStretch> stretches;
  const auto count = static_cast<double>(samples.points_px.size());
  for (std::size_t n = 0; n < samples.points_px.size(); ++n) {
    const std::array<std::uint16_t, 2> labels{labelNow(samples.points_px[n], sides[0]),
                                              labelNow(samples.points_px[n], sides[1])};
    const auto at = [&](std::size_t k) {
      return Point2(jambs_map.a + (jambs_map.b - jambs_map.a) * (static_cast<double>(k) / count));
    };
    const bool unseen = labels[0] == 0 || labels[1] == 0;
    if (!stretches.empty() && (unseen || stretches.back().labels == labels)) {
      stretches.back().jambs_map.b = at(n + 1);
    } else if (!unseen) {
      stretches.push_back({{stretches.empty() ? jambs_map.a : at(n), at(n + 1)}, labels});
    }
  }
  return stretches;
}

}  // namespace agrid

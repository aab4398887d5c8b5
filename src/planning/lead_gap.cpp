// SPDX-License-Identifier: BSD-3-Clause
#include "planning/lead_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace agrid::planning {
namespace {

double distanceTo(const Segment& segment, const Point2& p) {
  const Point2 along = segment.b - segment.a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((p - segment.a).dot(along) / length, 0.0, 1.0) : 0;
  return (segment.a + t * along - p).norm();
}

/// Where the lead is nearest to a door, along the lead.
double placeOf(const std::vector<Point2>& lead, const Segment& jambs) {
  double nearest = std::numeric_limits<double>::infinity();
  double place = 0;
  double length = 0;
  for (std::size_t i = 0; i < lead.size(); ++i) {
    if (i > 0) length += (lead[i] - lead[i - 1]).norm();
    const double distance = distanceTo(jambs, lead[i]);
    if (distance >= nearest) continue;
    nearest = distance;
    place = length;
  }
  return place;
}

}  // namespace

std::optional<LeadGap> findGap(const std::vector<Point2>& lead,
                               const std::function<LeadPlace(const Point2&)>& placeAt) {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < lead.size(); ++i) {
    if (placeAt(lead[i]) == LeadPlace::kReached) last = i;
  }
  if (!last || *last + 1 == lead.size()) return std::nullopt;
  std::size_t next = *last + 1;
  while (next + 1 < lead.size() && placeAt(lead[next]) != LeadPlace::kFree) ++next;
  LeadGap gap;
  gap.from = lead[*last];
  gap.middle = lead[(*last + next) / 2];
  for (std::size_t i = 1; i <= next; ++i) {
    (i <= *last ? gap.begin : gap.length) += (lead[i] - lead[i - 1]).norm();
  }
  return gap;
}

std::optional<LeadDoor> doorInGap(const std::vector<Point2>& lead,
                                  const std::vector<LeadDoor>& doors, const LeadGap& gap,
                                  double slack) {
  std::optional<LeadDoor> found;
  double nearest = gap.length / 2 + slack;
  for (const LeadDoor& door : doors) {
    const double middle = gap.begin + gap.length / 2;
    const double distance = std::abs(placeOf(lead, door.jambs) - middle);
    if (distance > nearest) continue;
    nearest = distance;
    found = door;
  }
  return found;
}

bool cross(const Segment& a, const Segment& b) {
  const auto side = [](const Segment& line, const Point2& p) {
    const Point2 along = line.b - line.a;
    const Point2 to = p - line.a;
    return along.x() * to.y() - along.y() * to.x();
  };
  return side(a, b.a) * side(a, b.b) <= 0 && side(b, a.a) * side(b, a.b) <= 0;
}

}  // namespace agrid::planning

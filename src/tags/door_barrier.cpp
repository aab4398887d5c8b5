// SPDX-License-Identifier: BSD-3-Clause
#include "tags/door_barrier.h"

#include "tags/pixel_line.h"

namespace agrid {
namespace {

constexpr double kCarryOn = 0.3;  // [m]

/// Half of a barrier: from the centre of the door to one jamb.
struct Arm {
  std::vector<std::size_t> pixels;
  double length_px = 0;
};

Arm findArm(const cv::Mat1b& free_space, const MapGeometry& geometry, const Point2& center_px,
            const Point2& direction, double half_width_px) {
  Arm arm;
  const double reach = half_width_px + kCarryOn / geometry.resolution;
  std::size_t within_width = 0;
  bool at_wall = false;
  walkPixels(center_px, direction, [&](Pixel p, double entered) {
    at_wall = !geometry.contains(p) || free_space(p.y, p.x) == 0;
    arm.length_px = entered;
    if (at_wall || entered > reach) return false;
    arm.pixels.push_back(geometry.index(p));
    if (entered < half_width_px) within_width = arm.pixels.size();
    return true;
  });
  if (!at_wall) {
    arm.pixels.resize(within_width);
    arm.length_px = half_width_px;
  }
  return arm;
}

}  // namespace

std::optional<Barrier> findBarrier(const cv::Mat1b& free_space, const MapGeometry& geometry,
                                   const DoorTag& tag) {
  const auto center = geometry.pixelAt(tag.pose_map.position);
  if (!center || free_space(center->y, center->x) == 0) return std::nullopt;
  const Pose2 image_from_map = inverse(geometry.map_from_image);
  const Point2 center_px = image_from_map * tag.pose_map.position / geometry.resolution;
  const double yaw = image_from_map.yaw + tag.pose_map.yaw;
  const Point2 across(-std::sin(yaw), std::cos(yaw));
  const double half_width_px = tag.width > 0 ? tag.width / geometry.resolution / 2
                                             : std::hypot(geometry.width, geometry.height);
  const Arm left = findArm(free_space, geometry, center_px, across, half_width_px);
  const Arm right = findArm(free_space, geometry, center_px, -across, half_width_px);

  const auto inMap = [&](const Point2& point_px) {
    return Point2(geometry.map_from_image * Point2(point_px * geometry.resolution));
  };
  Barrier barrier{
      tag,
      {inMap(center_px - across * right.length_px), inMap(center_px + across * left.length_px)},
      left.pixels};
  barrier.pixels.insert(barrier.pixels.end(), right.pixels.begin(), right.pixels.end());
  return barrier;
}

void closeDoors(const std::vector<Barrier>& barriers, cv::Mat1b& free_space) {
  for (const Barrier& barrier : barriers) {
    for (const std::size_t i : barrier.pixels) free_space.ptr()[i] = 0;
  }
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "planning/plan_oracle.h"

namespace agrid::test {

constexpr double kPi = 3.14159265358979323846;
constexpr double kResolution = 0.1;

/// A hall of free pixels with a wall around it.
inline std::vector<std::string> hall(int width, int height) {
  std::vector<std::string> rows(static_cast<std::size_t>(height),
                                std::string(static_cast<std::size_t>(width), '.'));
  rows.front() = rows.back() = std::string(static_cast<std::size_t>(width), '#');
  for (std::string& row : rows) row.front() = row.back() = '#';
  return rows;
}

/// Fills columns [x0, x1) of rows [y0, y1), counted from the drawing's top.
inline void fill(std::vector<std::string>& rows, int x0, int x1, int y0, int y1) {
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x)
      rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = '#';
  }
}

inline Scene halls(const std::vector<std::string>& rows) {
  Scene scene = test::sceneOf(rows, kResolution);
  scene.grid.geometry.map_from_image = {{-2, 1}, 0.3};
  scene.x_lines = scene.y_lines = 3;
  return scene;
}

inline PlanRequest request(const Scene& scene, const Point2& from, double yaw, const Point2& to,
                           double goal_yaw) {
  PlanRequest request = requestFrom(scene.at(from.x(), from.y()), scene.at(to.x(), to.y()));
  const double map_yaw = scene.grid.geometry.map_from_image.yaw;
  request.start.yaw = yaw + map_yaw;
  std::get<PlanPoint>(request.goal).yaw = goal_yaw + map_yaw;
  return request;
}

inline double turned(const Pose2& a, const Pose2& b) {
  return std::abs(std::remainder(b.yaw - a.yaw, 2 * kPi));
}

/// How far the robot drives in its direction from one pose to the next; backwards is negative.
inline double driven(const Pose2& a, const Pose2& b) {
  const double middle = a.yaw + std::remainder(b.yaw - a.yaw, 2 * kPi) / 2;
  return (b.position - a.position).dot(Point2(std::cos(middle), std::sin(middle)));
}

}  // namespace agrid::test

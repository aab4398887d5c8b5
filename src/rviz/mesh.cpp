// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"

#include <cmath>

namespace agrid_map_rviz {
namespace {

Mesh::Vertex vertexAt(double x, double y, const Color& color) {
  return {static_cast<float>(x), static_cast<float>(y), color};
}

Mesh::Vertex vertexAt(const geometry_msgs::Point& point, const Color& color) {
  return vertexAt(point.x, point.y, color);
}

}  // namespace

void Mesh::addStroke(const geometry_msgs::Point& a, const geometry_msgs::Point& b, double width,
                     const Color& color) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (!(length > 0)) return;
  const double across_x = -(b.y - a.y) / length * width / 2;
  const double across_y = (b.x - a.x) / length * width / 2;
  const Vertex corners[] = {vertexAt(a.x - across_x, a.y - across_y, color),
                            vertexAt(b.x - across_x, b.y - across_y, color),
                            vertexAt(b.x + across_x, b.y + across_y, color),
                            vertexAt(a.x + across_x, a.y + across_y, color)};
  for (const int i : {0, 1, 2, 0, 2, 3}) triangles.push_back(corners[i]);
}

void Mesh::addLine(const geometry_msgs::Point& a, const geometry_msgs::Point& b,
                   const Color& color) {
  lines.push_back(vertexAt(a, color));
  lines.push_back(vertexAt(b, color));
}

void Mesh::addQuad(const std::vector<geometry_msgs::Point>& corners, const Color& color) {
  for (const std::size_t i : {0, 1, 2, 0, 2, 3}) {
    triangles.push_back(vertexAt(corners.at(i), color));
  }
}

void Mesh::addOutline(const std::vector<geometry_msgs::Point>& corners, double width,
                      const Color& color) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    addStroke(corners[i], corners[(i + 1) % corners.size()], width, color);
  }
}

void Mesh::addDisc(const geometry_msgs::Point& center, double radius, const Color& color) {
  constexpr int kSides = 12;
  for (int i = 0; i < kSides; ++i) {
    triangles.push_back(vertexAt(center, color));
    for (const int corner : {i, i + 1}) {
      const double angle = 2 * M_PI * corner / kSides;
      triangles.push_back(vertexAt(center.x + radius * std::cos(angle),
                                   center.y + radius * std::sin(angle), color));
    }
  }
}

}  // namespace agrid_map_rviz

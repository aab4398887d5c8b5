// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <geometry_msgs/Point.h>

namespace agrid_map_rviz {

struct Color {
  float r = 1, g = 1, b = 1, a = 1;
};

/// Flat shapes of one height, in the frame of the message that they show [m].
struct Mesh {
  struct Vertex {
    float x, y;
    Color color;
  };
  std::vector<Vertex> triangles;  ///< three for each triangle
  std::vector<Vertex> lines;      ///< two for each line, one pixel wide

  /// A line that is as wide on the floor as it says [m].
  void addStroke(const geometry_msgs::Point& a, const geometry_msgs::Point& b, double width,
                 const Color& color);
  void addLine(const geometry_msgs::Point& a, const geometry_msgs::Point& b, const Color& color);
  /// A four-cornered face, its corners in order.
  void addQuad(const std::vector<geometry_msgs::Point>& corners, const Color& color);
  void addOutline(const std::vector<geometry_msgs::Point>& corners, double width,
                  const Color& color);
  void addDisc(const geometry_msgs::Point& center, double radius, const Color& color);
};

}  // namespace agrid_map_rviz

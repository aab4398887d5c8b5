// SPDX-License-Identifier: BSD-3-Clause
// Prints the paper's Table 1 for maps in map_server form, and how well each grid fits the walls:
// the share of edge pixels whose centre lies within one pixel of a grid line, beside that of a
// uniform grid with as many lines on each axis.
// usage: agrid_table1 [--direction DEGREES] MAP.yaml...
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "agrid/grid/grid_construction.h"
#include "agrid/map/map_io.h"
#include "grid/edge_image.h"

namespace {

using agrid::Point2;

std::vector<Point2> edgePoints(const agrid::OccupancyMap& map, const agrid::WallParams& params) {
  const cv::Mat edges = agrid::detectEdges(map, params);
  std::vector<Point2> points;
  for (int row = 0; row < edges.rows; ++row) {
    for (int x = 0; x < edges.cols; ++x) {
      if (edges.at<std::uint8_t>(row, x) != 0) {
        points.push_back(map.geometry().center({x, edges.rows - 1 - row}));
      }
    }
  }
  return points;
}

bool isNear(const std::vector<double>& lines, double value, double distance) {
  const auto above = std::lower_bound(lines.begin(), lines.end(), value - distance);
  return above != lines.end() && *above <= value + distance;
}

double shareNearLines(const std::vector<Point2>& points_map, const agrid::AGrid& grid,
                      double resolution) {
  const agrid::Pose2 grid_from_map = inverse(grid.mapFromGrid());
  const double distance = resolution * (1 + 1e-6);
  std::size_t near = 0;
  for (const Point2& point_map : points_map) {
    const Point2 p = grid_from_map * point_map;
    near += isNear(grid.x(), p.x(), distance) || isNear(grid.y(), p.y(), distance) ? 1 : 0;
  }
  return static_cast<double>(near) /
         static_cast<double>(std::max<std::size_t>(1, points_map.size()));
}

std::vector<double> spacedEvenly(const std::vector<double>& edges) {
  std::vector<double> even = edges;
  const auto last = static_cast<double>(edges.size() - 1);
  for (std::size_t i = 0; i < even.size(); ++i) {
    even[i] = edges.front() + (edges.back() - edges.front()) * static_cast<double>(i) / last;
  }
  return even;
}

void printRow(const std::string& path, const agrid::WallParams& params) {
  const agrid::OccupancyMap map(agrid::loadMap(path).grid);
  const auto start = std::chrono::steady_clock::now();
  const agrid::Walls walls = agrid::limitCells(agrid::detectWalls(map, params));
  const agrid::AGrid grid = agrid::constructGrid(walls);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;

  const std::vector<Point2> points = edgePoints(map, params);
  const agrid::AGrid uniform(grid.mapFromGrid(), spacedEvenly(grid.x()), spacedEvenly(grid.y()));
  const double resolution = map.geometry().resolution;
  const double turn = (grid.mapFromGrid().yaw - map.geometry().map_from_image.yaw) * 180 / CV_PI;
  std::printf("| %s | %zu | %zu | %d x %d | %zu + %zu | %.2f | %.3f | %.3f | %.1f |\n",
              path.c_str(), map.geometry().pixelCount(), grid.cellCount(), grid.columns(),
              grid.rows(), walls.vertical.size(), walls.horizontal.size(), turn,
              shareNearLines(points, grid, resolution), shareNearLines(points, uniform, resolution),
              spent.count());
}

}  // namespace

int main(int argc, char** argv) {
  agrid::WallParams params;
  int first = 1;
  if (argc > 2 && std::string(argv[1]) == "--direction") {
    params.estimate_direction = false;
    params.direction_deg = std::atof(argv[2]);
    first = 3;
  }
  std::puts(
      "| map | pixels | cells | columns x rows | wall lines | direction [deg] | edge pixels on "
      "lines | the same, uniform | ms |\n|---|---|---|---|---|---|---|---|---|");
  try {
    for (int i = first; i < argc; ++i) printRow(argv[i], params);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "agrid_table1: %s\n", error.what());
    return 1;
  }
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "tools/pictures.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "exchange/area_colors.h"
#include "tools/canvas.h"

namespace agrid::tools {
namespace {

const MapGreys kPlain{255, 60, 214};
const MapGreys kFaint{255, 140, 235};
const cv::Scalar kDoorBlue(215, 95, 20);
const cv::Scalar kLineBlue(190, 120, 60);
const cv::Scalar kLineRed(70, 70, 215);
constexpr int kOverviewSide = 1600;        // [px]
constexpr double kOverviewEmphasis = 1.6;  // it is shown small
const cv::Scalar kInk(80, 55, 45);

/// A line of the grid frame across the whole grid: at `offset` of axis 0 (x) or 1 (y).
void gridLine(Canvas& canvas, const Structure& structure, int axis, double offset,
              const cv::Scalar& color) {
  Point2 a = Point2::Zero();
  Point2 b = structure.walls.extent;
  a[axis] = offset;
  b[axis] = offset;
  canvas.line(structure.walls.map_from_grid * a, structure.walls.map_from_grid * b, color, 1);
}

void drawDoors(Canvas& canvas, const AreaMap& areas) {
  for (const Door& door : areas.doors) {
    const bool shut = door.kind == DoorKind::kDoor;
    const int thickness = shut ? 2 * canvas.stroke() : canvas.stroke();
    canvas.line(door.jambs_map.a, door.jambs_map.b, kDoorBlue, thickness);
    const double radius = shut ? 1.6 * canvas.stroke() : 1.1 * canvas.stroke();
    canvas.dot(door.jambs_map.a, radius, kDoorBlue);
    canvas.dot(door.jambs_map.b, radius, kDoorBlue);
  }
}

void fillAreas(Canvas& canvas, const SemanticMap& map) {
  const std::vector<cv::Vec3b> colors = areaColors(map.area_map);
  canvas.paintPixels([&](std::size_t pixel) -> const cv::Vec3b* {
    const std::uint16_t label = map.area_map.pixel_labels[pixel];
    return label == 0 ? nullptr : &colors[label - 1U];
  });
}

/// Names shrink in small areas, but stay readable.
void drawNames(Canvas& canvas, const AreaMap& areas, double down_px) {
  for (const Area& area : areas.areas) {
    const double room = 2.2 * area.anchor_clearance * canvas.pixelsPerMetre();
    const double width = Canvas::textWidth(area.name, canvas.textHeight());
    const double shrink = std::clamp(room / std::max(width, 1.0), 0.6, 1.0);
    const double height = std::max(7.0, canvas.textHeight() * shrink);
    // Where even small names are far wider than their areas, they would only cover each other.
    if (Canvas::textWidth(area.name, height) > 4 * room) continue;
    canvas.text(area.anchor_map, down_px + (down_px > 0 ? height / 2 : 0), area.name, height);
  }
}

void drawEdgesOfGraph(Canvas& canvas, const SemanticMap& map) {
  const AreaMap& areas = map.area_map;
  for (std::size_t i = 0; i < map.graph.passages.size(); ++i) {
    for (const Passage& passage : map.graph.passages[i]) {
      if (passage.area < i) continue;
      const Point2 door = areas.doors[passage.door].jambs_map.midpoint();
      canvas.line(areas.areas[i].anchor_map, door, kInk, canvas.stroke());
      canvas.line(door, areas.areas[passage.area].anchor_map, kInk, canvas.stroke());
    }
  }
}

void drawNodes(Canvas& canvas, const SemanticMap& map) {
  const std::vector<cv::Vec3b> colors = areaColors(map.area_map);
  for (std::size_t i = 0; i < map.area_map.areas.size(); ++i) {
    const Point2& anchor = map.area_map.areas[i].anchor_map;
    canvas.dot(anchor, 3.6 * canvas.stroke(), kInk);
    canvas.dot(anchor, 2.6 * canvas.stroke(), colors[i]);
  }
}

}  // namespace

cv::Mat drawEdges(const cv::Mat& edges) {
  cv::Mat grey = fitted(255 - edges);
  cv::Mat picture;
  cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
  return picture;
}

cv::Mat drawWalls(const Structure& structure) {
  Canvas canvas(*structure.map, kPlain);
  canvas.blend(0.65, [&](Canvas& layer) {
    for (const WallLine& line : structure.walls.vertical) {
      gridLine(layer, structure, 0, line.offset, kLineRed);
    }
    for (const WallLine& line : structure.walls.horizontal) {
      gridLine(layer, structure, 1, line.offset, kLineBlue);
    }
  });
  return canvas.image();
}

cv::Mat drawGrid(const Structure& structure) {
  Canvas canvas(*structure.map, kPlain);
  canvas.blend(0.6, [&](Canvas& layer) {
    for (const double x : structure.grid->x()) gridLine(layer, structure, 0, x, kLineBlue);
    for (const double y : structure.grid->y()) gridLine(layer, structure, 1, y, kLineBlue);
  });
  return canvas.image();
}

cv::Mat drawAreas(const SemanticMap& map) {
  Canvas canvas(map.map(), kPlain);
  fillAreas(canvas, map);
  drawDoors(canvas, map.area_map);
  drawNames(canvas, map.area_map, 0);
  return canvas.image();
}

cv::Mat drawGraph(const SemanticMap& map) {
  Canvas canvas(map.map(), kFaint);
  canvas.blend(0.35, [&](Canvas& layer) { fillAreas(layer, map); });
  drawEdgesOfGraph(canvas, map);
  drawDoors(canvas, map.area_map);
  drawNodes(canvas, map);
  drawNames(canvas, map.area_map, 4.0 * canvas.stroke());
  return canvas.image();
}

cv::Mat drawOverview(const SemanticMap& map) {
  const Canvas before(map.map(), kPlain);
  Canvas after(map.map(), kPlain, kOverviewEmphasis);
  fillAreas(after, map);
  drawEdgesOfGraph(after, map);
  drawDoors(after, map.area_map);
  drawNodes(after, map);
  drawNames(after, map.area_map, 4.0 * after.stroke());
  // Side by side, or above each other where the map is wide.
  const bool wide = before.image().cols > 1.4 * before.image().rows;
  const int gap = std::max(4, std::max(before.image().cols, before.image().rows) / 60);
  cv::Mat space(wide ? gap : before.image().rows, wide ? before.image().cols : gap, CV_8UC3,
                cv::Scalar::all(255));
  cv::Mat both;
  const std::vector<cv::Mat> parts{before.image(), space, after.image()};
  if (wide) cv::vconcat(parts, both);
  if (!wide) cv::hconcat(parts, both);
  const double scale = static_cast<double>(kOverviewSide) / std::max(both.cols, both.rows);
  if (scale < 1) cv::resize(both, both, {}, scale, scale, cv::INTER_AREA);
  return both;
}

}  // namespace agrid::tools

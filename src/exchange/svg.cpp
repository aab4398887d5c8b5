// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>

#include <tinyxml2.h>

#include "exchange/area_colors.h"
#include "exchange/faces.h"
#include "exchange/plain_text.h"
#include "exchange/writers.h"

namespace agrid {
namespace {

constexpr double kPixelsPerMetre = 40;  // of the drawing at its own size
constexpr double kLargestText = 0.5;    // [m]
constexpr double kSmallestText = 0.12;
constexpr double kLetterWidth = 0.6;  // of the height of text

/// The drawing's bounds in the map frame [m].
struct Bounds {
  explicit Bounds(const MapGeometry& geometry) {
    const double width = geometry.width * geometry.resolution;
    const double height = geometry.height * geometry.resolution;
    low = high = geometry.map_from_image.position;
    for (const Point2& corner : {Point2(width, 0), Point2(0, height), Point2(width, height)}) {
      low = low.cwiseMin(geometry.map_from_image * corner);
      high = high.cwiseMax(geometry.map_from_image * corner);
    }
  }
  Point2 low;
  Point2 high;
};

std::string pair(const Point2& point) {
  return plainNumber(point.x()) + " " + plainNumber(point.y());
}

std::string ringPath(const PixelRing& ring, const MapGeometry& geometry) {
  std::string path;
  for (const Point2& corner : mapPolygon(ring, geometry)) {
    path += (path.empty() ? "M" : "L") + pair(corner);
  }
  return path + "Z";
}

std::string facesPath(const std::vector<Face>& faces, const MapGeometry& geometry) {
  std::string path;
  for (const Face& face : faces) {
    path += ringPath(face.outer, geometry);
    for (const PixelRing& hole : face.holes) path += ringPath(hole, geometry);
  }
  return path;
}

std::string rgb(const cv::Vec3b& bgr) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", bgr[2], bgr[1], bgr[0]);
  return text;
}

/// Writes a drawing whose coordinates are those of the map frame [m].
class Drawing {
 public:
  explicit Drawing(const Bounds& bounds) {
    const Point2 size = bounds.high - bounds.low;
    xml_.PushHeader(false, true);
    open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                 {"xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape"},
                 {"width", plainNumber(kPixelsPerMetre * size.x())},
                 {"height", plainNumber(kPixelsPerMetre * size.y())},
                 {"viewBox", pair({bounds.low.x(), -bounds.high.y()}) + " " + pair(size)}});
    shape("rect", {{"x", plainNumber(bounds.low.x())},
                   {"y", plainNumber(-bounds.high.y())},
                   {"width", plainNumber(size.x())},
                   {"height", plainNumber(size.y())},
                   {"fill", "#d8dade"}});
  }

  using Attributes = std::vector<std::pair<const char*, std::string>>;

  void open(const char* element, const Attributes& attributes) {
    xml_.OpenElement(element, true);
    for (const auto& [name, value] : attributes) xml_.PushAttribute(name, value.c_str());
  }
  void close() { xml_.CloseElement(true); }

  void layer(const char* id, Attributes attributes) {
    attributes.insert(attributes.begin(), {{"id", id},
                                           {"inkscape:groupmode", "layer"},
                                           {"inkscape:label", id},
                                           {"transform", "scale(1,-1)"}});
    open("g", attributes);
  }

  /// @param title  shown where the pointer rests; empty: none
  void shape(const char* element, const Attributes& attributes, const std::string& title = "") {
    open(element, attributes);
    if (!title.empty()) textIn("title", {}, title);
    close();
  }

  void textIn(const char* element, const Attributes& attributes, const std::string& text) {
    open(element, attributes);
    xml_.PushText(plainText(text).c_str());
    close();
  }

  std::string finish() {
    close();
    return xml_.CStr();
  }

 private:
  tinyxml2::XMLPrinter xml_;
};

std::string idOf(const char* kind, std::uint32_t id) { return kind + std::to_string(id); }

void drawAreas(const SemanticMap& map, Drawing& drawing) {
  const std::vector<cv::Vec3b> colors = areaColors(map.area_map);
  const std::vector<std::vector<Face>> faces = areaFaces(map);
  drawing.layer("areas", {{"fill-rule", "evenodd"}});
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const Area& area = map.area_map.areas[k];
    drawing.shape("path",
                  {{"id", idOf("area_", static_cast<std::uint32_t>(area.id))},
                   {"fill", rgb(colors[k])},
                   {"d", facesPath(faces[k], map.map().geometry())}},
                  area.name);
  }
  drawing.close();
}

void drawCells(const SemanticMap& map, Drawing& drawing) {
  const AGrid& grid = map.grid();
  std::string path;
  const auto line = [&](const Point2& a, const Point2& b) {
    path += "M" + pair(grid.mapFromGrid() * a) + "L" + pair(grid.mapFromGrid() * b);
  };
  for (const double x : grid.x()) line({x, grid.y().front()}, {x, grid.y().back()});
  for (const double y : grid.y()) line({grid.x().front(), y}, {grid.x().back(), y});
  drawing.layer("cells", {{"fill", "none"},
                          {"stroke", "#8090a0"},
                          {"stroke-width", "0.01"},
                          {"stroke-opacity", "0.6"}});
  drawing.shape("path", {{"d", path}});
  drawing.close();
}

void drawWalls(const SemanticMap& map, Drawing& drawing) {
  const MapGeometry& geometry = map.map().geometry();
  cv::Mat1b walls(geometry.height, geometry.width);
  const auto& pixels = map.map().pixels();
  std::transform(pixels.begin(), pixels.end(), walls.begin(), [](Occupancy pixel) {
    return static_cast<std::uint8_t>(pixel == Occupancy::kOccupied);
  });
  drawing.layer("walls", {{"fill", "#303438"}, {"fill-rule", "evenodd"}});
  drawing.shape("path", {{"d", facesPath(facesOf(walls), geometry)}});
  drawing.close();
}

void drawDoors(const SemanticMap& map, Drawing& drawing) {
  drawing.layer("doors", {{"fill", "none"}, {"stroke-linecap", "round"}});
  for (const Door& door : map.area_map.doors) {
    const char* color = door.state == DoorState::kClosed ? "#c02020" : "#145fd7";
    const char* width = door.kind == DoorKind::kDoor ? "0.12" : "0.05";
    drawing.shape("path",
                  {{"id", idOf("door_", static_cast<std::uint32_t>(door.id))},
                   {"stroke", color},
                   {"stroke-width", width},
                   {"d", "M" + pair(door.jambs_map.a) + "L" + pair(door.jambs_map.b)}},
                  door.name);
  }
  drawing.close();
}

void drawObjects(const SemanticMap& map, Drawing& drawing) {
  drawing.layer("objects", {{"fill", "#e05030"}, {"fill-opacity", "0.8"}});
  for (const ObjectTag& object : map.knowledge.objects) {
    const Point2 size = object.size.cwiseMax(0.1);  // a point would not be seen
    const double degrees = object.pose_map.yaw * 180 / 3.14159265358979323846;
    drawing.shape("rect",
                  {{"id", idOf("object_", static_cast<std::uint32_t>(object.id))},
                   {"transform", "translate(" + pair(object.pose_map.position) + ") rotate(" +
                                     plainNumber(degrees) + ")"},
                   {"x", plainNumber(-size.x() / 2)},
                   {"y", plainNumber(-size.y() / 2)},
                   {"width", plainNumber(size.x())},
                   {"height", plainNumber(size.y())}},
                  object.name);
  }
  drawing.close();
}

/// @param room  width that there is for it [m]
void drawName(const std::string& name, const Point2& place_map, double room, Drawing& drawing) {
  if (name.empty()) return;
  const double fits = room / (kLetterWidth * static_cast<double>(name.size()));
  drawing.textIn("text",
                 {{"transform", "translate(" + pair(place_map) + ") scale(1,-1)"},
                  {"font-size", plainNumber(std::clamp(fits, kSmallestText, kLargestText))}},
                 name);
}

void drawNames(const SemanticMap& map, Drawing& drawing) {
  drawing.layer("names", {{"font-family", "sans-serif"},
                          {"text-anchor", "middle"},
                          {"dominant-baseline", "middle"},
                          {"fill", "#202020"}});
  for (const Area& area : map.area_map.areas) {
    drawName(area.name, area.anchor_map, 2 * area.anchor_clearance, drawing);
  }
  for (const ObjectTag& object : map.knowledge.objects) {
    drawName(object.name, object.pose_map.position, object.size.x(), drawing);
  }
  drawing.close();
}

}  // namespace

std::string svgText(const SemanticMap& map, const std::string& frame_id) {
  Drawing drawing{Bounds(map.map().geometry())};
  drawing.textIn("desc", {}, "metres in frame '" + frame_id + "', y up within each layer");
  drawAreas(map, drawing);
  drawCells(map, drawing);
  drawWalls(map, drawing);
  drawDoors(map, drawing);
  drawObjects(map, drawing);
  drawNames(map, drawing);
  return drawing.finish();
}

}  // namespace agrid

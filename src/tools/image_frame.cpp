// SPDX-License-Identifier: BSD-3-Clause
#include "tools/image_frame.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace agrid::tools {

Point2 imagePoint(const Point2& point_map, const MapGeometry& geometry) {
  const Point2 q = inverse(geometry.map_from_image) * point_map / geometry.resolution;
  return {q.x() - 0.5, geometry.height - 0.5 - q.y()};
}

Point2 mapPoint(const Point2& image_px, const MapGeometry& geometry) {
  return geometry.map_from_image *
         Point2((image_px.x() + 0.5) * geometry.resolution,
                (geometry.height - 0.5 - image_px.y()) * geometry.resolution);
}

std::string segmentsCsv(const std::vector<Segment>& segments_map, const MapGeometry& geometry) {
  std::string text = "x1,y1,x2,y2\n";
  for (const Segment& segment : segments_map) {
    const Point2 a = imagePoint(segment.a, geometry);
    const Point2 b = imagePoint(segment.b, geometry);
    text += shortNumber(a.x()) + "," + shortNumber(a.y()) + "," + shortNumber(b.x()) + "," +
            shortNumber(b.y()) + "\n";
  }
  return text;
}

std::string shortNumber(double value) {
  const double rounded = std::round(value * 1000) / 1000;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(12);
  text << (rounded == 0 ? 0.0 : rounded);  // never "-0"
  return text.str();
}

}  // namespace agrid::tools

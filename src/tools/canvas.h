// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "agrid/map/occupancy_map.h"
#include "opencv2/core.hpp"

namespace agrid::tools {

/// Greys of a metric map; 255 is white.
struct MapGreys {
  unsigned char free = 255;
  unsigned char occupied = 0;
  unsigned char unknown = 205;
};

/// A picture of a metric map to draw on: small maps are enlarged, large ones reduced. Points are
/// given in the map's frame [m].
class Canvas {
 public:
  /// @param emphasis  enlarges lines and text, for a picture that will be shown small
  Canvas(const OccupancyMap& map, const MapGreys& greys, double emphasis = 1);

  const cv::Mat& image() const { return image_; }
  /// Pixels of the picture for a metre.
  double pixelsPerMetre() const { return scale_ / geometry_.resolution; }
  /// Thickness of a clearly visible line.
  int stroke() const { return stroke_; }
  /// Usual height of capital letters [px].
  double textHeight() const { return text_height_; }

  /// Paints every pixel of the map for which there is a colour; none: nullptr.
  void paintPixels(const std::function<const cv::Vec3b*(std::size_t)>& color_of);
  void line(const Point2& a, const Point2& b, const cv::Scalar& color, int thickness);
  void polygon(const std::vector<Point2>& corners, const cv::Scalar& color, int thickness);
  void dot(const Point2& center, double radius_px, const cv::Scalar& color);
  /// Text centred at a point on a halo, moved down by `down_px`.
  void text(const Point2& center, double down_px, const std::string& text, double height_px);
  /// Width of a text [px].
  static double textWidth(const std::string& text, double height_px);
  /// Draws on a copy and blends it in.
  void blend(double opacity, const std::function<void(Canvas&)>& draw);

 private:
  cv::Point fixedPoint(const Point2& point_map) const;

  const OccupancyMap& map_;
  MapGeometry geometry_;
  double scale_ = 1;  ///< pixels of the picture for a pixel of the map
  int stroke_ = 1;
  double text_height_ = 10;
  cv::Mat image_;
};

/// An 8-bit picture of the map's size (row 0 at the top), enlarged or reduced like a canvas.
cv::Mat fitted(const cv::Mat& image);

}  // namespace agrid::tools

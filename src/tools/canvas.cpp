// SPDX-License-Identifier: BSD-3-Clause
#include "tools/canvas.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace agrid::tools {
namespace {

constexpr int kLargestSide = 4000;      // [px] of a picture
constexpr int kUsualSide = 1800;        // [px] that small maps are enlarged to, at most
constexpr double kWidestStroke = 0.12;  // [m]
constexpr double kHighestText = 0.5;    // [m]
constexpr int kShift = 4;               // binary digits after the point in OpenCV's coordinates

double scaleFor(int width, int height) {
  const int side = std::max(width, height);
  if (side > kLargestSide) return static_cast<double>(kLargestSide) / side;
  return std::clamp(kUsualSide / side, 1, 8);
}

cv::Mat drawMap(const OccupancyMap& map, const MapGreys& greys) {
  const MapGeometry& geometry = map.geometry();
  cv::Mat image(geometry.height, geometry.width, CV_8UC1);
  for (int y = 0; y < image.rows; ++y) {
    const Occupancy* from = map.pixels().data() + geometry.index({0, image.rows - 1 - y});
    auto* to = image.ptr<unsigned char>(y);
    for (int x = 0; x < image.cols; ++x) {
      to[x] = from[x] == Occupancy::kFree       ? greys.free
              : from[x] == Occupancy::kOccupied ? greys.occupied
                                                : greys.unknown;
    }
  }
  cv::Mat picture;
  cv::cvtColor(fitted(image), picture, cv::COLOR_GRAY2BGR);
  return picture;
}

}  // namespace

cv::Mat fitted(const cv::Mat& image) {
  const double scale = scaleFor(image.cols, image.rows);
  cv::Mat result;
  const cv::Size size(std::max(1, static_cast<int>(std::lround(image.cols * scale))),
                      std::max(1, static_cast<int>(std::lround(image.rows * scale))));
  cv::resize(image, result, size, 0, 0, scale < 1 ? cv::INTER_AREA : cv::INTER_NEAREST);
  return result;
}

Canvas::Canvas(const OccupancyMap& map, const MapGreys& greys, double emphasis)
    : map_(map),
      geometry_(map.geometry()),
      scale_(scaleFor(geometry_.width, geometry_.height)),
      image_(drawMap(map, greys)) {
  // By the picture's size, but on large buildings no more than fits between walls.
  const int side = std::max(image_.cols, image_.rows);
  const double widest = std::min(side / 700.0, kWidestStroke * pixelsPerMetre());
  stroke_ = std::max(1, static_cast<int>(std::lround(emphasis * widest)));
  const double highest = std::min(side / 95.0, kHighestText * pixelsPerMetre());
  text_height_ = emphasis * std::clamp(highest, 9.0, 30.0);
}

cv::Point Canvas::fixedPoint(const Point2& point_map) const {
  const Point2 q = inverse(geometry_.map_from_image) * point_map / geometry_.resolution;
  const double ratio_x = static_cast<double>(image_.cols) / geometry_.width;
  const double ratio_y = static_cast<double>(image_.rows) / geometry_.height;
  const auto fixed = [](double v) { return static_cast<int>(std::lround(v * (1 << kShift))); };
  return {fixed(q.x() * ratio_x - 0.5), fixed((geometry_.height - q.y()) * ratio_y - 0.5)};
}

void Canvas::paintPixels(const std::function<const cv::Vec3b*(std::size_t)>& color_of) {
  for (int v = 0; v < image_.rows; ++v) {
    auto* row = image_.ptr<cv::Vec3b>(v);
    const auto y = static_cast<int>((image_.rows - 1 - v + 0.5) * geometry_.height / image_.rows);
    for (int u = 0; u < image_.cols; ++u) {
      const auto x = static_cast<int>((u + 0.5) * geometry_.width / image_.cols);
      if (const cv::Vec3b* color = color_of(geometry_.index({x, y}))) row[u] = *color;
    }
  }
}

void Canvas::line(const Point2& a, const Point2& b, const cv::Scalar& color, int thickness) {
  cv::line(image_, fixedPoint(a), fixedPoint(b), color, thickness, cv::LINE_AA, kShift);
}

void Canvas::polygon(const std::vector<Point2>& corners, const cv::Scalar& color, int thickness) {
  std::vector<cv::Point> points;
  for (const Point2& corner : corners) points.push_back(fixedPoint(corner));
  cv::polylines(image_, points, true, color, thickness, cv::LINE_AA, kShift);
}

void Canvas::dot(const Point2& center, double radius_px, const cv::Scalar& color) {
  const auto radius = static_cast<int>(std::lround(radius_px * (1 << kShift)));
  cv::circle(image_, fixedPoint(center), radius, color, cv::FILLED, cv::LINE_AA, kShift);
}

double Canvas::textWidth(const std::string& text, double height_px) {
  const double scale = cv::getFontScaleFromHeight(cv::FONT_HERSHEY_SIMPLEX, 100, 1) / 100;
  int baseline = 0;
  return cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale * height_px, 1, &baseline).width;
}

void Canvas::text(const Point2& center, double down_px, const std::string& text, double height_px) {
  const double scale =
      cv::getFontScaleFromHeight(cv::FONT_HERSHEY_SIMPLEX, 100, 1) / 100 * height_px;
  const int thickness = std::max(1, static_cast<int>(height_px / 9));
  const cv::Point middle = fixedPoint(center);
  const cv::Point corner(
      (middle.x >> kShift) - static_cast<int>(textWidth(text, height_px) / 2),
      (middle.y >> kShift) + static_cast<int>(std::lround(height_px / 2 + down_px)));
  const int halo = thickness + std::max(2, static_cast<int>(height_px / 4));
  cv::putText(image_, text, corner, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar::all(255), halo,
              cv::LINE_AA);
  cv::putText(image_, text, corner, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(60, 35, 25),
              thickness, cv::LINE_AA);
}

void Canvas::blend(double opacity, const std::function<void(Canvas&)>& draw) {
  Canvas layer = *this;
  layer.image_ = image_.clone();
  draw(layer);
  cv::addWeighted(layer.image_, opacity, image_, 1 - opacity, 0, image_);
}

}  // namespace agrid::tools

// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ground.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "planning/clock.h"

namespace agrid::bench {
namespace {

constexpr int kFreeGrey = 250;
constexpr std::int64_t kSide = 32768;

std::int64_t floorDivided(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);  // b > 0
}

std::int64_t ceilDivided(std::int64_t a, std::int64_t b) { return -floorDivided(-a, b); }

/// A point on the lattice, the image's upper left corner being (0, 0).
struct LatticePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

LatticePoint onLattice(const Point2& p_px) {
  return {std::llround((p_px.x() + 0.5) * static_cast<double>(kSide)),
          std::llround((p_px.y() + 0.5) * static_cast<double>(kSide))};
}

bool columnIsFree(const Ground& ground, std::int64_t x, std::int64_t first, std::int64_t last) {
  for (std::int64_t y = first; y <= last; ++y) {
    if (!ground.isFree(static_cast<int>(x), static_cast<int>(y))) return false;
  }
  return true;
}

/// Pixels of an image that are free for a point: 255, else 0.
cv::Mat1b lightOf(const std::string& image_path) {
  const cv::Mat1b image = cv::imread(image_path, cv::IMREAD_GRAYSCALE);
  if (image.empty()) throw std::runtime_error(image_path + " cannot be read");
  cv::Mat1b light;
  cv::compare(image, kFreeGrey, light, cv::CMP_GE);
  return light;
}

}  // namespace

std::int32_t Ground::componentAt(const Point2& p_px) const {
  const int x = static_cast<int>(std::floor(p_px.x() + 0.5));
  const int y = static_cast<int>(std::floor(p_px.y() + 0.5));
  return contains(x, y) ? components[index(x, y)] : 0;
}

bool Ground::connects(const Point2& a_px, const Point2& b_px) const {
  const std::int32_t component = componentAt(a_px);
  return component != 0 && component == componentAt(b_px);
}

std::vector<double> transformSeconds(const std::string& image_path) {
  const cv::Mat1b light = lightOf(image_path);
  const int repetitions = light.total() > 50'000'000 ? 2 : 5;
  std::vector<double> seconds;
  cv::setNumThreads(1);
  for (int i = 0; i < repetitions; ++i) {
    cv::Mat1f distances;
    seconds.push_back(secondsOf(
        [&] { cv::distanceTransform(light, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE); }));
  }
  cv::setNumThreads(-1);
  return seconds;
}

Ground readGround(const std::string& image_path, double radius_px) {
  const cv::Mat1b light = lightOf(image_path);
  Ground ground;
  ground.width = light.cols;
  ground.height = light.rows;
  cv::Mat1f distances;
  cv::distanceTransform(light, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  // the transform's squares are integers below 2^24 where they are near the radius
  cv::Mat1b free(light.size());
  std::transform(distances.begin(), distances.end(), free.begin(), [&](float d) {
    const double square = std::round(static_cast<double>(d) * static_cast<double>(d));
    return static_cast<std::uint8_t>(square > radius_px * radius_px ? 255 : 0);
  });
  cv::rectangle(free, {0, 0, light.cols, light.rows}, 0);
  distances.release();
  cv::Mat1i components;
  cv::connectedComponents(free, components, 4, CV_32S);
  ground.free.assign(free.begin(), free.end());
  ground.components.assign(components.begin(), components.end());
  return ground;
}

bool segmentIsFree(const Ground& ground, const Point2& a_px, const Point2& b_px) {
  LatticePoint a = onLattice(a_px);
  LatticePoint b = onLattice(b_px);
  if (a.x > b.x) std::swap(a, b);
  const std::int64_t dx = b.x - a.x;
  const std::int64_t dy = b.y - a.y;
  // closed squares: a point on the line between two pixels touches both
  for (std::int64_t x = ceilDivided(a.x, kSide) - 1; x <= floorDivided(b.x, kSide); ++x) {
    // y times dx where the segment enters and leaves the column
    std::int64_t enter = a.y;
    std::int64_t leave = b.y;
    std::int64_t scale = 1;
    if (dx > 0) {
      scale = dx;
      enter = a.y * dx + (std::max(a.x, x * kSide) - a.x) * dy;
      leave = a.y * dx + (std::min(b.x, (x + 1) * kSide) - a.x) * dy;
    }
    if (enter > leave) std::swap(enter, leave);
    if (!columnIsFree(ground, x, ceilDivided(enter, scale * kSide) - 1,
                      floorDivided(leave, scale * kSide))) {
      return false;
    }
  }
  return true;
}

}  // namespace agrid::bench

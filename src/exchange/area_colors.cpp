// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/area_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace agrid {
namespace {

constexpr double kGoldenRatio = 0.6180339887498949;
constexpr double kLeastApart = 0.11;  // of the circle of hues, between neighbours
constexpr int kTries = 12;

double hueDistance(double a, double b) {
  const double d = std::abs(a - b);
  return std::min(d, 1 - d);
}

cv::Vec3b fromHsv(double hue, double saturation, double value) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + hue * 6, 6.0);
    const double part = std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    return static_cast<unsigned char>(std::lround(255 * value * (1 - saturation * part)));
  };
  return {channel(1), channel(3), channel(5)};
}

}  // namespace

std::vector<cv::Vec3b> areaColors(const AreaMap& areas) {
  std::map<AreaId, std::vector<AreaId>> neighbours;
  for (const Door& door : areas.doors) {
    neighbours[door.areas[0]].push_back(door.areas[1]);
    neighbours[door.areas[1]].push_back(door.areas[0]);
  }
  std::map<AreaId, double> hues;
  std::vector<cv::Vec3b> colors;
  for (const Area& area : areas.areas) {
    const auto id = static_cast<std::uint32_t>(area.id);
    double hue = std::fmod(id * kGoldenRatio, 1.0);
    const auto clashes = [&](AreaId other) {
      const auto found = hues.find(other);
      return found != hues.end() && hueDistance(found->second, hue) < kLeastApart;
    };
    const std::vector<AreaId>& around = neighbours[area.id];
    for (int i = 0; i < kTries && std::any_of(around.begin(), around.end(), clashes); ++i) {
      hue = std::fmod(hue + kGoldenRatio, 1.0);
    }
    hues[area.id] = hue;
    constexpr std::array<double, 3> kSaturations{0.30, 0.22, 0.38};
    colors.push_back(fromHsv(hue, kSaturations[id % 3], 0.97));
  }
  return colors;
}

cv::Scalar darker(const cv::Vec3b& color) {
  return {color[0] * 0.55, color[1] * 0.55, color[2] * 0.55};
}

}  // namespace agrid

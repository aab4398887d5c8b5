// SPDX-License-Identifier: BSD-3-Clause
#include "tags/area_seeds.h"

#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace agrid {
namespace {

std::vector<Pixel> findPeaks(const Division& division, const MapGeometry& geometry,
                             const std::vector<Pixel>& given, const AreaParams& params) {
  const Basins& basins = division.basins;
  std::vector<bool> is_given(basins.basins.size(), false);
  for (const Pixel p : given) {
    const std::uint32_t basin = basins.of_pixel[geometry.index(p)];
    if (basin != Basins::kNone) is_given[division.area_of[basin]] = true;
  }
  std::vector<Pixel> peaks;
  for (std::size_t i = 0; i < basins.basins.size(); ++i) {
    const Basin& basin = basins.basins[i];
    if (division.area_of[i] != i || is_given[i]) continue;
    if (basin.height * geometry.resolution < params.min_area_clearance) continue;
    peaks.push_back(geometry.pixel(basin.peak));
  }
  return peaks;
}

std::vector<Pixel> findCentroids(const Relief& relief, const std::vector<Pixel>& given) {
  cv::Mat1i portions;
  cv::Mat1i stats;
  cv::Mat1d centroids;
  const int count =
      cv::connectedComponentsWithStats(relief.free_space, portions, stats, centroids, 4, CV_32S);
  constexpr double kGiven = -1;
  std::vector<double> nearest(static_cast<std::size_t>(count),
                              std::numeric_limits<double>::infinity());
  nearest[0] = kGiven;
  for (const Pixel p : given) nearest[static_cast<std::size_t>(portions(p.y, p.x))] = kGiven;
  std::vector<Pixel> seeds(nearest.size());
  for (int y = 0; y < portions.rows; ++y) {
    for (int x = 0; x < portions.cols; ++x) {
      const int portion = portions(y, x);
      const auto i = static_cast<std::size_t>(portion);
      const double distance = std::hypot(x - centroids(portion, 0), y - centroids(portion, 1));
      if (distance >= nearest[i]) continue;
      nearest[i] = distance;
      seeds[i] = {x, y};
    }
  }
  std::vector<Pixel> result;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    if (nearest[i] != kGiven) result.push_back(seeds[i]);
  }
  return result;
}

}  // namespace

std::vector<AreaTag> proposeSeeds(const Relief& relief, const Division& division,
                                  const MapGeometry& geometry, const std::vector<Tag>& tags,
                                  const AreaParams& params) {
  std::vector<Pixel> given;
  for (const Tag& tag : tags) {
    const auto* area = std::get_if<AreaTag>(&tag);
    if (const auto pixel = area ? geometry.pixelAt(area->seed_map) : std::nullopt) {
      given.push_back(*pixel);
    }
  }
  const auto pixels = params.method == AreaMethod::kPaper
                          ? findCentroids(relief, given)
                          : findPeaks(division, geometry, given, params);
  std::vector<AreaTag> seeds;
  for (const Pixel pixel : pixels) {
    AreaTag seed;
    seed.seed_map = geometry.center(pixel);
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace agrid

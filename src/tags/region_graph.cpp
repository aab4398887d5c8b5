// SPDX-License-Identifier: BSD-3-Clause
#include "tags/region_graph.h"

#include <algorithm>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "tags/pixel_runs.h"

namespace agrid {

RegionGraph::RegionGraph(const std::vector<std::uint32_t>& labels, std::size_t count,
                         const std::vector<Stretch>& stretches, const BorderSurvey& survey)
    : resolution_(survey.geometry().resolution), regions_(count), borders_(count) {
  collectShapes(labels, survey);
  for (const Stretch& stretch : stretches) {
    const auto number = static_cast<std::uint32_t>(profiles_.size());
    profiles_.push_back(survey.profileOf(stretch, labels));
    borders_[stretch.front().a][stretch.front().b].push_back({number, 0});
    borders_[stretch.front().b][stretch.front().a].push_back({number, 1});
  }
}

void RegionGraph::collectShapes(const std::vector<std::uint32_t>& labels,
                                const BorderSurvey& survey) {
  const auto columns = static_cast<std::size_t>(survey.geometry().width);
  std::vector<std::vector<cv::Point2f>> corners(regions_.size());
  for (std::size_t first = 0; first < labels.size(); first += columns) {
    const auto y = static_cast<float>(first / columns);
    const float* heights = survey.heights() + first;
    forEachRun(
        &labels[first], survey.geometry().width, [&](int begin, int end, std::uint32_t label) {
          if (label == Basins::kNone) return;
          const auto left = static_cast<float>(begin);
          const auto right = static_cast<float>(end);
          corners[label].insert(corners[label].end(),
                                {{left, y}, {right, y}, {left, y + 1}, {right, y + 1}});
          RegionShape& shape = regions_[label];
          shape.size += static_cast<double>(end - begin) * resolution_ * resolution_;
          const float highest = *std::max_element(heights + begin, heights + end);
          shape.clearance = std::max(shape.clearance, static_cast<double>(highest) * resolution_);
        });
  }
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    if (corners[i].empty()) continue;
    cv::convexHull(corners[i], regions_[i].hull);
    measureHull(regions_[i]);
  }
}

void RegionGraph::measureHull(RegionShape& shape) const {
  const double square = resolution_ * resolution_;
  shape.hull_size = cv::contourArea(shape.hull) * square;
  const cv::Size2f box = cv::minAreaRect(shape.hull).size;
  const double length =
      std::max({static_cast<double>(box.width), static_cast<double>(box.height), 1.});
  const double width = std::max(static_cast<double>(std::min(box.width, box.height)), 1.);
  shape.rectangle_size = length * width * square;
}

RegionShape RegionGraph::together(std::uint32_t a, std::uint32_t b) const {
  RegionShape both;
  both.size = regions_[a].size + regions_[b].size;
  both.clearance = std::max(regions_[a].clearance, regions_[b].clearance);
  std::vector<cv::Point2f> corners = regions_[a].hull;
  corners.insert(corners.end(), regions_[b].hull.begin(), regions_[b].hull.end());
  cv::convexHull(corners, both.hull);
  measureHull(both);
  return both;
}

bool RegionGraph::isSmaller(std::uint32_t a, std::uint32_t b) const {
  return std::make_pair(regions_[a].size, a) < std::make_pair(regions_[b].size, b);
}

BorderMeasures RegionGraph::measure(std::uint32_t a, std::uint32_t b) const {
  if (isSmaller(b, a)) std::swap(a, b);
  BorderMeasures measures;
  const Side* widest = nullptr;
  for (const Side& side : borders_[a].at(b)) {
    const BorderProfile& profile = profiles_[side.stretch];
    if (widest && profile.width <= profiles_[widest->stretch].width) continue;
    widest = &side;
  }
  measures.widest = &profiles_[widest->stretch];
  measures.smaller_side = &measures.widest->sides[widest->own];
  measures.larger_side = &measures.widest->sides[1U - widest->own];
  measures.smaller = &regions_[a];
  measures.larger = &regions_[b];
  measures.smaller_neighbours = borders_[a].size();
  measures.larger_neighbours = borders_[b].size();
  const RegionShape both = together(a, b);
  measures.common_hull_size = both.hull_size;
  measures.common_rectangle_size = both.rectangle_size;
  return measures;
}

std::uint32_t RegionGraph::merge(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t keeper = isSmaller(a, b) ? b : a;
  const std::uint32_t other = keeper == a ? b : a;
  regions_[keeper] = together(keeper, other);
  borders_[keeper].erase(other);
  for (const auto& [neighbour, sides] : borders_[other]) {
    std::vector<Side> from_there = std::move(borders_[neighbour][other]);
    borders_[neighbour].erase(other);
    if (neighbour == keeper) continue;
    auto& here = borders_[keeper][neighbour];
    here.insert(here.end(), sides.begin(), sides.end());
    auto& there = borders_[neighbour][keeper];
    there.insert(there.end(), from_there.begin(), from_there.end());
  }
  borders_[other].clear();
  return keeper;
}

}  // namespace agrid

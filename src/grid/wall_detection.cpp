// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/grid/wall_detection.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "agrid/grid/main_direction.h"
#include "grid/edge_frame.h"
#include "grid/edge_image.h"
#include "grid/spaced_lines.h"

namespace agrid {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("WallParams." + what);
}

void checkParams(const WallParams& p) {
  require(p.canny_low >= 0 && p.canny_low <= p.canny_high && std::isfinite(p.canny_high),
          "canny_low: " + std::to_string(p.canny_low) + " is not in [0, canny_high]");
  require(p.min_threshold_votes >= 0,
          "min_threshold_votes: " + std::to_string(p.min_threshold_votes) + " is below 0");
  require(p.max_threshold_votes > p.min_threshold_votes,
          "max_threshold_votes: " + std::to_string(p.max_threshold_votes) +
              " is not above min_threshold_votes");
  require(p.threshold_step_votes >= 1,
          "threshold_step_votes: " + std::to_string(p.threshold_step_votes) + " is below 1");
  require(p.min_line_distance_px > 0 && std::isfinite(p.min_line_distance_px),
          "min_line_distance_px: " + std::to_string(p.min_line_distance_px) + " is not above 0");
  require(p.distance_resolution_px >= 0.5 && std::isfinite(p.distance_resolution_px),
          "distance_resolution_px: " + std::to_string(p.distance_resolution_px) + " is below 0.5");
  require(std::isfinite(p.direction_deg), "direction_deg: not a finite number");
}

/// The threshold of the last round.
int lastThreshold(const WallParams& params) {
  const int range = params.max_threshold_votes - params.min_threshold_votes - 1;
  return params.max_threshold_votes -
         range / params.threshold_step_votes * params.threshold_step_votes;
}

/// What OpenCV's distances lack to be distances from the edge of the image. It measures from the
/// centre of the first pixel, and takes half a bin too much where the number of bins is even.
double offsetOfFirstBin(const cv::Mat& edges, double resolution_px) {
  const int bins = cvRound((2.0 * (edges.cols + edges.rows) + 1) / resolution_px);
  return 0.5 + (bins % 2 == 0 ? resolution_px / 2 : 0);
}

/// Alg. 1, lines 3, 4 and 6 for one of the two angles. The accumulator is the same in each round,
/// so one transform with the last round's threshold returns all that the rounds return. Each angle
/// has its own transform because OpenCV keeps a line only if it beats its neighbours in distance
/// and angle: among two angles, a wall at x = 100 would hide a weaker one at y = 100.
/// @return distances from the left or top edge of the image [px], most votes first
std::vector<WallLine> findCandidates(const cv::Mat& edges, double angle, const WallParams& params) {
  constexpr double kAngleResolution = CV_PI / 2;
  const double resolution_px = params.distance_resolution_px;
  std::vector<cv::Vec3f> lines;
  cv::HoughLines(edges, lines, resolution_px, kAngleResolution, lastThreshold(params), 0, 0, angle,
                 angle + 0.75 * kAngleResolution);
  const double first_px = offsetOfFirstBin(edges, resolution_px);
  std::vector<WallLine> candidates;
  candidates.reserve(lines.size());
  for (const cv::Vec3f& line : lines) {
    candidates.push_back({line[0] + first_px, static_cast<int>(line[2])});
  }
  return candidates;
}

/// Alg. 1, lines 2, 5 and 7 to 15, for the lines of one direction. A candidate is looked at once,
/// in the first round whose threshold it exceeds: once refused it would be refused in all later
/// rounds, as the lines taken only become more and the distance asked for only grows.
std::vector<WallLine> acceptCandidates(const std::vector<WallLine>& candidates, double extent_px,
                                       const WallParams& params) {
  SpacedLines accepted(extent_px);
  auto candidate = candidates.begin();
  for (int threshold = params.max_threshold_votes; threshold > params.min_threshold_votes;
       threshold -= params.threshold_step_votes) {
    const double min_distance = std::max(
        static_cast<double>(params.max_threshold_votes) / threshold, params.min_line_distance_px);
    for (; candidate != candidates.end() && candidate->votes > threshold; ++candidate) {
      accepted.addIfFar(*candidate, min_distance);
    }
  }
  return accepted.lines();
}

/// The frame to lay the grid in. A long map cannot be turned at will: its bounding rectangle may
/// be any number of times larger than the map.
EdgeFrame gridFrame(const MapGeometry& geometry, double direction,
                    std::vector<std::string>& warnings) {
  EdgeFrame frame = edgeFrame(geometry, direction);
  if (frame.extent_px.prod() <= maxTurnedPixels(geometry)) return frame;
  warnings.push_back("the map is too long to lay a grid at " +
                     std::to_string(direction * 180 / CV_PI) + " degrees: it lies along the image");
  return edgeFrame(geometry, 0);
}

}  // namespace

Walls detectWalls(const OccupancyMap& map, const WallParams& params) {
  checkParams(params);
  const double resolution = map.geometry().resolution;
  const cv::Mat edges = detectEdges(map, params);
  const double direction = params.estimate_direction ? mainDirection(sampleEdges(edges))
                                                     : foldDirection(params.direction_deg);
  Walls walls;
  const EdgeFrame frame = gridFrame(map.geometry(), direction, walls.warnings);
  const double width_px = frame.extent_px.x();
  const double height_px = frame.extent_px.y();
  walls.map_from_grid = map.geometry().map_from_image * frame.image_from_grid;
  walls.extent = frame.extent_px * resolution;

  const cv::Mat turned = turnEdges(edges, frame);
  for (const WallLine& line :
       acceptCandidates(findCandidates(turned, 0, params), width_px, params)) {
    walls.vertical.push_back({line.offset * resolution, line.votes});
  }
  for (const WallLine& line :
       acceptCandidates(findCandidates(turned, CV_PI / 2, params), height_px, params)) {
    walls.horizontal.push_back({(height_px - line.offset) * resolution, line.votes});
  }
  std::reverse(walls.horizontal.begin(), walls.horizontal.end());
  if (walls.vertical.empty() && walls.horizontal.empty()) {
    walls.warnings.push_back("no wall line found: the grid has one cell");
  }
  return walls;
}

}  // namespace agrid

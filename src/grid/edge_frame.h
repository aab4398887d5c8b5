// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "agrid/geometry/pose2.h"
#include "agrid/map/map_geometry.h"

namespace agrid {

/// The grid frame of a map, laid along a direction of its image frame.
struct EdgeFrame {
  Pose2 image_from_grid;  ///< [m, rad]
  Point2 extent_px;       ///< size of the map's bounding rectangle in the grid frame [px]
  double resolution = 1;  ///< side of a pixel [m]
};

/// The frame whose x axis has this direction [rad] in the image frame and whose first quadrant just
/// holds the map.
EdgeFrame edgeFrame(const MapGeometry& geometry, double direction);

/// Size of the largest turned image that turnEdges should be asked for: OpenCV counts its pixels in
/// 32 bits, and memory must stay in proportion to the map.
double maxTurnedPixels(const MapGeometry& geometry);

/// A direction of walls [deg] as radians in (-pi/4, pi/4]; walls are alike every 90 degrees.
double foldDirection(double direction_deg);

/// Centres of edge pixels in the image frame [px], evenly chosen if there are many.
std::vector<Point2> sampleEdges(const cv::Mat& edges);

/// The edge image (row 0 = top) with its pixels moved into the grid frame (row 0 = top); the image
/// itself if that lies along the image.
cv::Mat turnEdges(const cv::Mat& edges, const EdgeFrame& frame);

}  // namespace agrid

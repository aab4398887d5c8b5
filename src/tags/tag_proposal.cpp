// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/tags/tag_proposal.h"

#include <cmath>
#include <set>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "tags/aligned_view.h"
#include "tags/area_seeds.h"
#include "tags/division.h"
#include "tags/narrow_passages.h"
#include "tags/pixel_neighbours.h"
#include "tags/relief.h"
#include "tags/tag_numbering.h"

namespace agrid {
namespace {

DoorTag doorAcross(const Segment& passage_px, const MapGeometry& geometry) {
  const Point2 way = passage_px.b - passage_px.a;
  const double yaw_through = std::atan2(-way.x(), way.y());
  DoorTag door;
  door.pose_map =
      geometry.map_from_image * Pose2{passage_px.midpoint() * geometry.resolution, yaw_through};
  door.width = passage_px.length() * geometry.resolution;
  return door;
}

/// Whether a barrier has two portions of the free space beside it; portion 0 is none.
bool partsTwo(const Barrier& barrier, const cv::Mat1i& portions, const MapGeometry& geometry) {
  std::set<int> beside;
  for (const std::size_t i : barrier.pixels) {
    for (const Pixel step : kNeighbours) {
      const Pixel p = geometry.pixel(i) + step;
      if (geometry.contains(p)) beside.insert(portions(p.y, p.x));
    }
  }
  beside.erase(0);
  return beside.size() > 1;
}

/// The narrow passages that part two portions of the map when all of them are closed.
std::vector<DoorTag> proposeDoors(const OccupancyMap& map, const std::vector<Tag>& given,
                                  const AreaParams& params) {
  const MapGeometry& geometry = map.geometry();
  Relief relief = makeRelief(map, given, params);
  std::vector<Barrier> barriers;
  for (const Segment& passage : findNarrowPassages(relief, geometry, params)) {
    auto barrier = findBarrier(relief.free_space, geometry, doorAcross(passage, geometry));
    if (barrier) barriers.push_back(std::move(*barrier));
  }
  closeDoors(barriers, relief.free_space);
  cv::Mat1i portions;
  cv::connectedComponents(relief.free_space, portions, 4, CV_32S);
  std::vector<DoorTag> doors;
  for (const Barrier& barrier : barriers) {
    if (partsTwo(barrier, portions, geometry)) doors.push_back(barrier.tag);
  }
  return doors;
}

}  // namespace

std::vector<Tag> proposeTags(const OccupancyMap& map, const std::vector<Tag>& given,
                             const AreaParams& params, std::optional<double> walls_yaw) {
  validate(params);
  std::vector<Tag> proposed;
  if (params.method == AreaMethod::kPaper) {
    addNumbered(proposeDoors(map, given, params), given, proposed);
  }
  std::vector<Tag> known = given;
  known.insert(known.end(), proposed.begin(), proposed.end());
  const AlignedView view(map, params, walls_yaw.value_or(map.geometry().map_from_image.yaw));
  known = view.tagsOnView(known);
  const Relief relief = makeRelief(view.map(), known, params);
  const Division division = divide(relief, view.geometry().resolution, params);
  addNumbered(proposeSeeds(relief, division, view.geometry(), known, params), given, proposed);
  return proposed;
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "areas/paper_watershed.h"

#include <opencv2/imgproc.hpp>

#include "tags/basins.h"

namespace agrid {
namespace {

/// The opening of every area at once: a window that lies in one area is kept by it, and no window
/// reaches into another. Areas are the numbers from 1, 0 is none.
cv::Mat1f openAreas(const cv::Mat1f& areas, int side) {
  const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {side, side});
  cv::Mat1f lowest;
  cv::Mat1f highest;
  cv::erode(areas, lowest, window);
  cv::dilate(areas, highest, window);
  lowest.setTo(0, lowest != highest);
  // an even window has no middle: reflect it, or the result would be shifted
  const cv::Point anchor(side - 1 - side / 2, side - 1 - side / 2);
  cv::Mat1f opened;
  cv::dilate(lowest, opened, window, anchor);
  return opened;
}

}  // namespace

std::vector<std::uint32_t> floodContours(const cv::Mat1b& free_space,
                                         const std::vector<std::size_t>& seeds, int opening_px) {
  cv::Mat1i markers(free_space.size(), 0);
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    markers.ptr<int>()[seeds[s]] = static_cast<int>(s) + 1;
  }
  cv::Mat contours;
  cv::cvtColor(free_space * 255, contours, cv::COLOR_GRAY2BGR);
  cv::watershed(contours, markers);

  // watershed() also floods the walls, and gives -1 to the lines between areas and to the rim
  markers.setTo(0, (markers < 0) | (free_space == 0));
  cv::Mat1f areas;
  markers.convertTo(areas, CV_32F);
  if (opening_px > 1) areas = openAreas(areas, opening_px);
  std::vector<std::uint32_t> labels(free_space.total(), Basins::kNone);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const float area = areas.ptr<float>()[i];
    if (area > 0) labels[i] = static_cast<std::uint32_t>(area) - 1;
  }
  return labels;
}

}  // namespace agrid

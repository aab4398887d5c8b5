// SPDX-License-Identifier: BSD-3-Clause
#include "tools/room_pictures.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "agrid/map/map_io.h"

namespace agrid::tools {
namespace {

using Labels = std::vector<std::uint16_t>;

constexpr int kMaxRooms = std::numeric_limits<std::uint16_t>::max();
constexpr int kLeastSpread = 40;
constexpr double kLeastColoured = 0.05;
constexpr int kLeastWhite = 250;
constexpr int kNoLocation = 255;

cv::Mat readPicture(const std::string& path, int mode, const MapGeometry& geometry) {
  cv::Mat picture;
  try {
    picture = cv::imread(path, mode);
  } catch (const cv::Exception& error) {
    throw FileError(FileErrorCode::kImage, path + ": " + error.err);
  }
  if (picture.empty()) throw FileError(FileErrorCode::kImage, path + ": cannot be read");
  if (picture.cols != geometry.width || picture.rows != geometry.height) {
    throw FileError(FileErrorCode::kImage,
                    path + ": " + std::to_string(picture.cols) + " x " +
                        std::to_string(picture.rows) + " pixels, the map has " +
                        std::to_string(geometry.width) + " x " + std::to_string(geometry.height));
  }
  return picture;
}

/// Labels of a picture by its pixels' numbers, the lowest row first.
Labels labelsOf(const cv::Mat1i& numbers, const std::string& path) {
  Labels labels;
  labels.reserve(numbers.total());
  for (int y = numbers.rows - 1; y >= 0; --y) {
    for (int x = 0; x < numbers.cols; ++x) {
      if (numbers(y, x) > kMaxRooms) {
        throw FileError(FileErrorCode::kImage, path + ": more than 65535 rooms");
      }
      labels.push_back(static_cast<std::uint16_t>(numbers(y, x)));
    }
  }
  return labels;
}

/// The colour as a number, 0 if it is grey.
int colourCode(const cv::Vec3b& bgr) {
  const auto [least, most] = std::minmax({bgr[0], bgr[1], bgr[2]});
  return most - least > kLeastSpread ? bgr[0] | bgr[1] << 8 | bgr[2] << 16 : 0;
}

cv::Mat1i grey(const std::string& path, const MapGeometry& geometry) {
  const cv::Mat picture = readPicture(path, cv::IMREAD_UNCHANGED, geometry);
  if (picture.channels() != 1) throw FileError(FileErrorCode::kImage, path + ": is not grey");
  cv::Mat1i numbers;
  picture.convertTo(numbers, CV_32S);
  return numbers;
}

}  // namespace

Labels readNumberedRooms(const std::string& path, const MapGeometry& geometry) {
  return labelsOf(grey(path, geometry), path);
}

Labels readLocations(const std::string& path, const MapGeometry& geometry) {
  cv::Mat1i numbers = grey(path, geometry);
  for (int& number : numbers) number = number == kNoLocation ? 0 : number + 1;
  return labelsOf(numbers, path);
}

Labels readPaintedRooms(const std::string& path, const MapGeometry& geometry) {
  const cv::Mat3b colours = readPicture(path, cv::IMREAD_COLOR, geometry);
  cv::Mat1i numbers(colours.size());
  std::transform(colours.begin(), colours.end(), numbers.begin(), colourCode);
  if (cv::countNonZero(numbers) > kLeastColoured * static_cast<double>(numbers.total())) {
    std::map<int, int> rooms;
    for (const int code : numbers) rooms[code] = 0;
    rooms.erase(0);
    int next = 0;
    for (auto& [code, room] : rooms) room = ++next;
    rooms[0] = 0;
    for (int& number : numbers) number = rooms.at(number);
  } else {
    const cv::Mat white = readPicture(path, cv::IMREAD_GRAYSCALE, geometry) > kLeastWhite;
    cv::connectedComponents(white, numbers, 8, CV_32S);
  }
  return labelsOf(numbers, path);
}

Labels readAreaPicture(const std::string& path, const MapGeometry& geometry) {
  const cv::Mat picture = readPicture(path, cv::IMREAD_UNCHANGED, geometry);
  const bool is_grey = picture.channels() == 1;
  const bool has_numbers =
      is_grey && (picture.depth() != CV_8U || cv::countNonZero(picture > kLeastWhite) == 0);
  return has_numbers ? readNumberedRooms(path, geometry) : readPaintedRooms(path, geometry);
}

}  // namespace agrid::tools

// SPDX-License-Identifier: BSD-3-Clause
// Maps with truth for `agrid_map_tool eval`, and what it says about them.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"
#include "tools/commands.h"

namespace agrid::tools {

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

inline Outcome eval(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"agrid_map_tool", "eval"});
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.code = run(arguments);
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.err = testing::internal::GetCapturedStderr();
  return outcome;
}

inline constexpr int kWidth = 170;
inline constexpr int kHeight = 80;
inline const cv::Rect kLeft(10, 10, 70, 60);
inline const cv::Rect kRight(84, 10, 76, 60);

/// Two rooms with a door of 1 m between them, 0.05 m per pixel.
inline void drawMap(const test::TemporaryFolder& folder, const std::string& name,
                    bool furnished = false) {
  cv::Mat1b image(kHeight, kWidth, std::uint8_t{0});
  image(kLeft) = 254;
  image(kRight) = 254;
  image(cv::Rect(80, 30, 4, 20)) = 254;
  if (furnished) image(cv::Rect(20, 20, 6, 6)) = 0;
  cv::imwrite(folder / (name + ".png"), image);
  folder.write(name + ".yaml", "image: " + std::filesystem::path(name).filename().string() +
                                   ".png\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

inline void drawWhiteRooms(const std::string& path) {
  cv::Mat1b rooms(kHeight, kWidth, std::uint8_t{0});
  rooms(kLeft) = 255;
  rooms(kRight) = 255;
  cv::imwrite(path, rooms);
}

/// A folder `office` with a map that needs truth.
inline void drawMapFolder(const test::TemporaryFolder& folder) {
  std::filesystem::create_directory(folder / "office");
  drawMap(folder, "office/map");
}

/// The value of a column in the CSV's line that begins so.
inline std::string cell(const std::string& csv, const std::string& begin,
                        const std::string& column) {
  std::istringstream lines(csv);
  std::string header;
  std::getline(lines, header);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(begin, 0) != 0) continue;
    std::istringstream names(header);
    std::istringstream values(line + ",");
    for (std::string name, value;
         std::getline(names, name, ',') && std::getline(values, value, ',');) {
      if (name == column) return value;
    }
  }
  return "missing";
}

}  // namespace agrid::tools

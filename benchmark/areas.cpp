// SPDX-License-Identifier: BSD-3-Clause
// Prints what areas and doors cost and how good they are: the processor time of finding them beside
// that of one exact distance transform of the same map, in turns, the medians; the memory at the
// peak beyond what was there before; on drawn offices, whose rooms and doors are known, the scores.
// usage: agrid_areas [--large] [--repeat N] [MAP.yaml...]
// Without maps: drawn offices of 1, 5 and 25 million pixels, with --large of 100 million as well.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <malloc.h>
#include <opencv2/imgproc.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "agrid/areas/area_segmentation.h"
#include "agrid/evaluation/office_generator.h"
#include "agrid/evaluation/scores.h"
#include "agrid/map/map_io.h"
#include "agrid/pipeline.h"

namespace {

using agrid::OccupancyMap;

constexpr std::uint32_t kSeed = 7;

/// Processor time of all threads: other programs don't count, nor does a second thread help.
double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

double secondsOf(const std::function<void()>& work) {
  const double start = processorSeconds();
  work();
  return processorSeconds() - start;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

cv::Mat1b freeMask(const OccupancyMap& map) {
  cv::Mat1b mask(map.geometry().height, map.geometry().width);
  std::transform(map.pixels().begin(), map.pixels().end(), mask.begin(), [](agrid::Occupancy o) {
    return static_cast<std::uint8_t>(o == agrid::Occupancy::kFree ? 255 : 0);
  });
  return mask;
}

std::size_t peakBytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stoul(line.substr(6)) * 1024;
  }
  return 0;
}

/// How far the resident memory rises while `work` runs, in a process of its own so that memory
/// kept from before cannot hide it [bytes].
std::size_t memoryOf(const std::function<void()>& work) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork");
  if (child == 0) {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
    const std::size_t before = peakBytes();
    work();
    const std::size_t risen = peakBytes() - before;
    const bool told = write(ends[1], &risen, sizeof risen) == sizeof risen;
    _exit(told ? 0 : 1);
  }
  close(ends[1]);
  std::size_t risen = 0;
  const bool read_all = read(ends[0], &risen, sizeof risen) == sizeof risen;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!read_all || status != 0) throw std::runtime_error("measuring the memory failed");
  return risen;
}

struct Cost {
  double transform_seconds = 0;
  double areas_seconds = 0;
  std::size_t bytes = 0;
};

Cost measure(const OccupancyMap& map, const agrid::AGrid& grid, int repetitions) {
  const auto find_areas = [&] { agrid::findAreas(map, grid, {}); };
  const cv::Mat1b mask = freeMask(map);
  const auto transform = [&] {
    cv::Mat distances;
    cv::distanceTransform(mask, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  };
  Cost cost;
  cost.bytes = memoryOf(find_areas);
  std::vector<double> transform_seconds;
  std::vector<double> areas_seconds;
  for (int i = 0; i < repetitions; ++i) {
    transform_seconds.push_back(secondsOf(transform));
    areas_seconds.push_back(secondsOf(find_areas));
  }
  cost.transform_seconds = median(transform_seconds);
  cost.areas_seconds = median(areas_seconds);
  return cost;
}

std::string qualityOf(const OccupancyMap& map, const agrid::AGrid& grid,
                      const agrid::Office& truth) {
  const agrid::AreaMap found = agrid::findAreas(map, grid, {}).area_map;
  std::vector<agrid::Segment> doors;
  for (const agrid::Door& door : found.doors) {
    const bool between = door.areas[0] != agrid::AreaId{0} && door.areas[1] != agrid::AreaId{0};
    if (between) doors.push_back(door.jambs_map);
  }
  const agrid::AreaScores areas = agrid::scoreAreas(map, found.pixel_labels.vector(), truth.rooms);
  const agrid::DoorScores at_doors = agrid::scoreDoors(doors, truth.doors_map);
  char text[160];
  std::snprintf(text, sizeof text, "%.3f | %.3f | %.3f | %.3f / %.3f | %zu | %zu", areas.iou_all,
                areas.mcc, areas.f1_50, at_doors.precision, at_doors.recall, areas.areas,
                areas.rooms);
  return text;
}

/// A map to measure, and what is true about it where that is known.
struct Subject {
  std::string name;
  agrid::OccupancyGrid grid;
  std::optional<agrid::Office> truth;
};

void printRow(const Subject& subject, int repetitions) {
  const auto map = std::make_shared<const OccupancyMap>(subject.grid);
  const agrid::Structure structure = agrid::extractStructure(map, {});
  const Cost cost = measure(*map, *structure.grid, repetitions);
  const auto pixels = static_cast<double>(map->pixels().size());
  std::printf(
      "| %s | %.2f | %.3f | %.3f | %.2f | %.1f | %s |\n", subject.name.c_str(), pixels / 1e6,
      cost.transform_seconds, cost.areas_seconds, cost.areas_seconds / cost.transform_seconds,
      static_cast<double>(cost.bytes) / pixels,
      subject.truth ? qualityOf(*map, *structure.grid, *subject.truth).c_str() : "| | | | |");
  std::fflush(stdout);
}

Subject drawnOffice(int side) {
  agrid::OfficeParams params;
  params.size = side;
  params.seed = kSeed;
  agrid::Office office = agrid::generateOffice(params);
  agrid::OccupancyGrid grid = std::move(office.grid);
  return {"office " + std::to_string(side), std::move(grid), std::move(office)};
}

struct Request {
  std::vector<std::string> maps;
  bool large = false;
  int repetitions = 5;
};

Request readRequest(int argc, char** argv) {
  Request request;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--large") {
      request.large = true;
    } else if (word == "--repeat" && i + 1 < argc) {
      request.repetitions = std::max(1, std::atoi(argv[++i]));
    } else if (word.rfind("--", 0) == 0) {
      throw std::runtime_error("usage: agrid_areas [--large] [--repeat N] [MAP.yaml...]");
    } else {
      request.maps.push_back(word);
    }
  }
  return request;
}

void printAll(const Request& request) {
  std::puts(
      "| map | Mpx | transform [s] | areas [s] | ratio | bytes per pixel | iou_all | mcc | f1 | "
      "door P / R | areas | rooms |\n|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const std::string& path : request.maps) {
    printRow({path, agrid::loadMap(path).grid, {}}, request.repetitions);
  }
  if (!request.maps.empty()) return;
  std::vector<int> sides{1000, 2236, 5000};
  if (request.large) sides.push_back(10000);
  for (const int side : sides) printRow(drawnOffice(side), request.repetitions);
}

}  // namespace

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  try {
    printAll(readRequest(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "agrid_areas: %s\n", error.what());
    return 1;
  }
  return 0;
}

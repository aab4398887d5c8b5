// SPDX-License-Identifier: BSD-3-Clause
// Prints what an edit costs on a large map: from the request to what the planner uses, and storing
// it; beside one distance transform of the map. Times are CPU times, but for storing.
//
// usage: agrid_edits MAP.yaml DIRECTORY [REPETITIONS]
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "agrid/map/map_io.h"
#include "agrid/pipeline.h"
#include "agrid/pipeline/edit.h"
#include "agrid/planning/planner.h"
#include "agrid/storage.h"
#include "planning/clock.h"

namespace {

using agrid::SemanticMap;
using agrid::bench::quantile;
using agrid::bench::secondsOf;

/// CPU time: what else the machine does matters little.
double cpuSecondsOf(const std::function<void()>& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

/// Seconds of each part, one value for each repetition.
struct Times {
  std::vector<double> decide, retag, store, planner, answer;
};

/// A place to which edits are made as the node makes them.
class Place {
 public:
  Place(std::shared_ptr<const SemanticMap> map, const std::string& directory)
      : map_(std::move(map)),
        planner_(std::make_shared<const agrid::Planner>(map_, agrid::PlannerParams{})),
        store_(directory, "edits") {
    store_.fold({map_->map().digest(), "map", map_->knowledge});
  }

  const SemanticMap& map() const { return *map_; }

  /// @return the id of what was edited
  std::uint32_t make(const agrid::EditRequest& request, Times& times) {
    agrid::Edit edit;
    times.decide.push_back(cpuSecondsOf([&] { edit = decide(request, *map_); }));
    if (!edit.changed()) throw std::runtime_error("an edit changed nothing: " + edit.message);
    std::shared_ptr<const SemanticMap> next;
    times.retag.push_back(cpuSecondsOf([&] {
      agrid::Knowledge known = map_->knowledge;
      for (const agrid::Change& change : edit.changes) apply(change, known);
      next = std::make_shared<const SemanticMap>(retag(*map_, known));
    }));
    times.store.push_back(
        secondsOf([&] { store_.append(difference(map_->knowledge, next->knowledge)); }));
    times.planner.push_back(
        cpuSecondsOf([&] { planner_ = std::make_shared<const agrid::Planner>(next, *planner_); }));
    times.answer.push_back(times.decide.back() + times.retag.back() + times.planner.back());
    map_ = std::move(next);
    return edit.id;
  }

 private:
  std::shared_ptr<const SemanticMap> map_;
  std::shared_ptr<const agrid::Planner> planner_;
  agrid::Store store_;
};

double transformSeconds(const agrid::OccupancyMap& map) {
  cv::Mat free(map.geometry().height, map.geometry().width, CV_8U);
  for (std::size_t i = 0; i < map.pixels().size(); ++i) {
    free.data[i] = map.pixels()[i] == agrid::Occupancy::kFree ? 1 : 0;
  }
  cv::Mat distance;
  cv::setNumThreads(1);
  std::vector<double> seconds;
  for (int i = 0; i < 3; ++i) {
    seconds.push_back(cpuSecondsOf(
        [&] { cv::distanceTransform(free, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE); }));
  }
  return quantile(seconds, 0.5);
}

void printRow(const char* what, const Times& times, double transform) {
  std::printf("| %s |", what);
  for (const auto* part :
       {&times.decide, &times.retag, &times.planner, &times.answer, &times.store}) {
    std::printf(" %.1f / %.1f |", 1e3 * quantile(*part, 0.5), 1e3 * quantile(*part, 1));
  }
  std::printf(" %.3f / %.3f |\n", quantile(times.answer, 0.5) / transform,
              quantile(times.answer, 1) / transform);
  std::fflush(stdout);
}

/// The n-th area, of those spread over the map.
const agrid::Area& areaOf(const SemanticMap& map, int n) {
  const auto& areas = map.area_map.areas;
  return areas[static_cast<std::size_t>(n) * 37 % areas.size()];
}

const agrid::Door& doorOf(const SemanticMap& map, int n) {
  const auto& doors = map.area_map.doors;
  return doors[static_cast<std::size_t>(n) * 41 % doors.size()];
}

void printEdits(Place& place, int repetitions, double transform) {
  Times renamed, put, closed, split, absent;
  for (int n = 0; n < repetitions; ++n) {
    const std::string number = std::to_string(n);
    agrid::AreaTag name;
    name.name = "office " + number;
    name.seed_map = areaOf(place.map(), n).anchor_map;
    name.source = agrid::TagSource::kManual;
    place.make(agrid::AddTag{name, true}, renamed);

    agrid::ObjectTag thing;
    thing.name = "thing " + number;
    thing.pose_map = {areaOf(place.map(), n + 1).anchor_map, 0};
    place.make(agrid::AddTag{thing}, put);

    place.make(agrid::SetDoor{doorOf(place.map(), n).id, agrid::DoorState::kClosed}, closed);

    agrid::DoorTag door;
    door.name = "screen " + number;
    door.pose_map = {areaOf(place.map(), n + 2).anchor_map, 0};
    door.source = agrid::TagSource::kManual;
    agrid::AddTag forced{door};
    forced.force = true;
    place.make(forced, split);

    const auto gone = static_cast<std::uint32_t>(doorOf(place.map(), n + 3).id);
    place.make(agrid::RemoveTag{agrid::TagKind::kDoor, gone}, absent);
  }
  printRow("an area is renamed", renamed, transform);
  printRow("an object is put", put, transform);
  printRow("a door is closed", closed, transform);
  printRow("a door that parts an area", split, transform);
  printRow("a door is removed, its areas are one", absent, transform);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 3) throw std::runtime_error("usage: agrid_edits MAP.yaml DIRECTORY [REPETITIONS]");
    const int repetitions = argc > 3 ? std::atoi(argv[3]) : 30;
    const auto metric = std::make_shared<const agrid::OccupancyMap>(agrid::loadMap(argv[1]).grid);
    const double transform = transformSeconds(*metric);
    Place place(
        std::make_shared<const SemanticMap>(annotate(agrid::extractStructure(metric, {}), {}, {})),
        argv[2]);
    std::printf("%zu pixels, %zu areas, %zu doors; one distance transform: %.0f ms\n\n",
                metric->pixels().size(), place.map().area_map.areas.size(),
                place.map().area_map.doors.size(), 1e3 * transform);
    std::printf(
        "| median / most of %d [ms] | decide | retag | planner | together | store | "
        "together / transform |\n|---|---:|---:|---:|---:|---:|---:|\n",
        repetitions);
    printEdits(place, repetitions, transform);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "agrid_edits: %s\n", error.what());
    return 1;
  }
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Prints how much memory a process gains with each new map, where two maps of a place take turns,
// tags are brought from one to the other and stored, and a planner follows.
//
// usage: agrid_map_cycles DIRECTORY [CYCLES [WARM_UP]]
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include "agrid/evaluation/office_generator.h"
#include "agrid/identity/recognition.h"
#include "agrid/pipeline.h"
#include "agrid/pipeline/edit.h"
#include "agrid/planning/planner.h"
#include "agrid/storage.h"

namespace {

using agrid::OccupancyMap;
using agrid::SemanticMap;

/// What this process has in memory [kB].
double residentKilobytes() {
  std::ifstream statm("/proc/self/statm");
  long all = 0;
  long resident = 0;
  statm >> all >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1024;
}

/// Least-squares slope of values at 0, step, 2 step ...
double slope(const std::vector<double>& values, double step) {
  const auto n = static_cast<double>(values.size());
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = step * static_cast<double>(i);
    sum_x += x;
    sum_y += values[i];
    sum_xx += x * x;
    sum_xy += x * values[i];
  }
  return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

/// A drawn office, and the same after a wall was put into it.
std::vector<OccupancyMap> twoMaps(int side) {
  agrid::OfficeParams params;
  params.size = side;
  params.seed = 7;
  agrid::OccupancyGrid grid = agrid::generateOffice(params).grid;
  std::vector<OccupancyMap> maps{OccupancyMap(grid)};
  for (int column = side / 4; column < side / 2; ++column) {
    for (int row = side / 2; row < side / 2 + 3; ++row) {
      grid.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                  static_cast<std::size_t>(column)] = 100;
    }
  }
  maps.emplace_back(grid);
  return maps;
}

/// Goes from map to map as the node does.
class Place {
 public:
  explicit Place(const std::string& directory) : store_(directory, "cycles") {}

  void take(const OccupancyMap& map) {
    const auto metric = std::make_shared<const OccupancyMap>(map);
    const SemanticMap fresh = annotate(agrid::extractStructure(metric, {}), {}, {});
    if (!map_) return use(fresh);
    const auto& known = map_->knowledge;
    const SemanticMap with_doors = retag(fresh, agrid::doorsFor("map", known, "map"));
    use(retag(with_doors, recognise(known, "map", with_doors, "map").knowledge));
  }

  /// Names the first area, puts a thing into it and switches a door.
  void edit(int cycle) {
    const agrid::Point2 anchor_map = map_->area_map.areas.at(0).anchor_map;  // the map ends
    agrid::AreaTag name;
    name.name = "kitchen " + std::to_string(cycle);
    name.seed_map = anchor_map;
    name.source = agrid::TagSource::kManual;
    make(agrid::AddTag{name, true});
    agrid::ObjectTag fridge;
    fridge.name = "fridge";
    fridge.pose_map = {anchor_map, 0};
    make(agrid::AddTag{fridge, true});
    make(agrid::SetDoor{map_->area_map.doors.at(0).id,
                        cycle % 4 < 2 ? agrid::DoorState::kClosed : agrid::DoorState::kOpen});
    if (store_.journalIsLong()) store_.fold({map_->map().digest(), "map", map_->knowledge});
  }

 private:
  void use(SemanticMap map) {
    map_ = std::make_shared<const SemanticMap>(std::move(map));
    planner_ = planner_ ? std::make_shared<const agrid::Planner>(map_, *planner_)
                        : std::make_shared<const agrid::Planner>(map_, agrid::PlannerParams{});
  }
  void make(const agrid::EditRequest& request) {
    const agrid::Edit edit = decide(request, *map_);
    if (!edit.changed()) return;
    agrid::Knowledge known = map_->knowledge;
    for (const agrid::Change& change : edit.changes) apply(change, known);
    SemanticMap next = retag(*map_, known);
    store_.append(difference(map_->knowledge, next.knowledge));
    use(std::move(next));
  }

  agrid::Store store_;
  std::shared_ptr<const SemanticMap> map_;
  std::shared_ptr<const agrid::Planner> planner_;
};

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 2) throw std::runtime_error("usage: agrid_map_cycles DIRECTORY [CYCLES [WARM_UP]]");
    const int cycles = argc > 2 ? std::atoi(argv[2]) : 10000;
    const int warm_up = argc > 3 ? std::atoi(argv[3]) : 1000;
    constexpr int kStep = 10;
    const std::vector<OccupancyMap> maps = twoMaps(320);
    Place place(argv[1]);
    std::vector<double> resident;
    for (int cycle = 0; cycle < warm_up + cycles; ++cycle) {
      place.take(maps[static_cast<std::size_t>(cycle % 2)]);
      place.edit(cycle);
      if (cycle >= warm_up && cycle % kStep == 0) resident.push_back(residentKilobytes());
      if (cycle % 1000 == 999) {
        std::printf("cycle %d: %.0f kB\n", cycle + 1, residentKilobytes());
        std::fflush(stdout);
      }
    }
    std::printf("%d cycles after %d: %.3f kB a cycle\n", cycles, warm_up, slope(resident, kStep));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "agrid_map_cycles: %s\n", error.what());
    return 1;
  }
  return 0;
}

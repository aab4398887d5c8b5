// SPDX-License-Identifier: BSD-3-Clause
// Prints how often areas keep their ids, and given names their rooms, while maps change: maps that
// a robot makes in 100 steps, with new noise in each, and drawn offices that are rebuilt. What
// counts as the same area is told in benchmark/identity/same_rooms.h.
//
// usage: agrid_identity [--shared DIR] [--steps N] [--offices N] [--only NAME]
//                       [--variant MAJORITY,MIN_SHARE,MIN_GIVEN_SHARE[,MIN_RETURN_SHARE]]...
//                       [--large] [--losses]
//
// Without --shared: drawn offices only. --large: the cost on a map of 25 million pixels, too.
// --losses: each id and name that was lost, for the first variant.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "agrid/evaluation/perturbation.h"
#include "agrid/map/map_io.h"
#include "agrid/pipeline.h"
#include "identity/office_changes.h"
#include "identity/reveal.h"
#include "identity/same_rooms.h"
#include "tools/eval_cases.h"
#include "tools/truth_files.h"

namespace {

using agrid::OccupancyMap;
using agrid::bench::Follower;
using agrid::bench::Tally;

/// What counts as the same, and how it is recognised.
struct Variant {
  double majority = 0;
  agrid::RecognitionParams params;
};

struct Request {
  std::string shared;
  std::string only;
  int steps = 100;
  int offices = 10;
  bool losses = false;
  bool large = false;
  std::vector<Variant> variants{{2. / 3, {}}, {1. / 2, {}}, {0.8, {}}};
};

/// A map that a robot makes.
struct Subject {
  std::string name;
  std::string yaml;
  std::string rooms;  ///< file of the true rooms; empty: the areas of the whole map are the truth
};

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

agrid::SemanticMap annotated(const OccupancyMap& map) {
  const auto shared = std::make_shared<const OccupancyMap>(map);
  return annotate(agrid::extractStructure(shared, {}), {}, {});
}

std::string percent(std::size_t part, std::size_t whole) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f %% of %zu",
                whole == 0 ? 100. : 100. * static_cast<double>(part) / static_cast<double>(whole),
                whole);
  return text;
}

void printHeader() {
  std::puts(
      "| sequence | same areas kept | areas back after a gap | rooms with their first id in the "
      "end | names on their room "
      "in "
      "the end | waiting | swapped | joined | cost of finding areas |\n"
      "|---|---|---|---|---|---|---|---|---|");
}

void printRow(const std::string& name, const Tally& t) {
  std::printf("| %s | %s | %s | %s | %s | %zu | %zu | %zu | %.1f %% |\n", name.c_str(),
              percent(t.kept, t.same).c_str(), percent(t.back, t.again).c_str(),
              percent(t.lasting, t.rooms).c_str(), percent(t.named, t.names).c_str(), t.waiting,
              t.swapped, t.joined, 100 * t.seconds / t.area_seconds);
  std::fflush(stdout);
}

/// Shows the same maps to a follower of each variant.
class Sequence {
 public:
  /// @param floors  see Follower
  Sequence(const std::vector<Variant>& variants, const std::vector<double>& floors) {
    for (const Variant& v : variants) followers_.emplace_back(v.params, v.majority, floors);
  }

  void add(const OccupancyMap& map, const std::vector<std::uint16_t>& rooms) {
    const double start = processorSeconds();
    const agrid::SemanticMap fresh = annotated(map);
    area_seconds_ += processorSeconds() - start;
    for (Follower& follower : followers_) follower.add(fresh, rooms);
  }

  /// @return what became of it, for each variant
  std::vector<Tally> finish(bool with_losses) const {
    std::vector<Tally> tallies;
    for (const Follower& follower : followers_) {
      tallies.push_back(follower.finish());
      tallies.back().area_seconds = area_seconds_;
    }
    if (with_losses && !followers_.empty()) {
      for (const std::string& loss : followers_.front().losses()) std::puts(("  " + loss).c_str());
    }
    return tallies;
  }

 private:
  std::vector<Follower> followers_;
  double area_seconds_ = 0;
};

std::vector<double> floorsOf(const std::vector<std::uint16_t>& rooms, const OccupancyMap& map) {
  std::vector<double> floors(std::size_t{1} + *std::max_element(rooms.begin(), rooms.end()), 0);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (map.pixels()[i] == agrid::Occupancy::kFree) floors[rooms[i]] += 1;
  }
  return floors;
}

std::vector<Tally> replay(const Subject& subject, agrid::bench::Seeing seeing,
                          const Request& request) {
  const OccupancyMap whole(agrid::loadMap(subject.yaml).grid);
  const std::vector<std::uint16_t> rooms = subject.rooms.empty()
                                               ? annotated(whole).area_map.pixel_labels.vector()
                                               : agrid::tools::readTrueRooms(subject.rooms, whole);
  const agrid::bench::Exploration exploration(whole, request.steps, seeing);
  Sequence sequence(request.variants, floorsOf(rooms, whole));
  for (int step = 1; step <= request.steps; ++step) {
    const OccupancyMap map(exploration.seen(step));
    sequence.add(map, labelsOn(map.geometry(), whole.geometry(), rooms));
  }
  return sequence.finish(request.losses);
}

std::vector<Tally> rebuild(std::uint32_t seed, const Request& request) {
  agrid::bench::ChangingOffice office(500, seed);
  Sequence sequence(request.variants, {});
  for (int step = 1; step <= request.steps; ++step) {
    if (step > 1) office.change();
    sequence.add(OccupancyMap(agrid::bench::withNoise(office.grid(), step)), office.rooms());
  }
  return sequence.finish(request.losses);
}

std::vector<Subject> subjectsIn(const Request& request) {
  std::vector<Subject> subjects;
  if (request.shared.empty()) return subjects;
  for (const char* folder : {"bormann", "real"}) {
    const auto found = agrid::tools::findEvalCases(request.shared + "/maps/" + folder, "");
    for (const auto& one : found.cases) subjects.push_back({one.name, one.map_yaml, one.rooms});
    for (const std::string& name : found.without_truth) {
      const std::string yaml = request.shared + "/maps/" + folder + "/" + name + "/map.yaml";
      if (std::filesystem::exists(yaml)) subjects.push_back({name, yaml, ""});
    }
  }
  return subjects;
}

/// Adds up the rows of a table, for each variant.
class Sums {
 public:
  void add(const std::string& name, const std::vector<Tally>& tallies) {
    printRow(name, tallies.front());
    sums_.resize(tallies.size());
    for (std::size_t v = 0; v < tallies.size(); ++v) sums_[v] += tallies[v];
  }
  void print(const std::string& name, const std::vector<Variant>& variants) const {
    for (std::size_t v = 0; v < sums_.size(); ++v) {
      char text[160];
      std::snprintf(text, sizeof text, "**all %s**, majority %.2f, min_share %.2f / %.2f",
                    name.c_str(), variants[v].majority, variants[v].params.min_share,
                    variants[v].params.min_given_share);
      printRow(text, sums_[v]);
    }
  }

 private:
  std::vector<Tally> sums_;
};

void printReplays(const Request& request, agrid::bench::Seeing seeing, const std::string& how) {
  Sums sums;
  for (const Subject& subject : subjectsIn(request)) {
    if (!request.only.empty() && subject.name.find(request.only) == std::string::npos) continue;
    sums.add(subject.name + ", " + how, replay(subject, seeing, request));
  }
  sums.print("seen by a " + how, request.variants);
}

void printOffices(const Request& request) {
  Sums sums;
  for (int seed = 1; seed <= request.offices; ++seed) {
    sums.add("office " + std::to_string(seed), rebuild(static_cast<std::uint32_t>(seed), request));
  }
  sums.print("offices", request.variants);
}

/// What it costs to recognise the same drawn office, with noise, beside finding its areas.
void printCost(int side) {
  agrid::OfficeParams params;
  params.size = side;
  params.seed = 7;
  const agrid::OccupancyGrid grid = agrid::generateOffice(params).grid;
  const agrid::Knowledge known = recognise({}, "", annotated(OccupancyMap(grid)), "map").knowledge;
  const OccupancyMap map(agrid::bench::withNoise(grid, 1));
  double start = processorSeconds();
  const agrid::SemanticMap fresh = annotated(map);
  const double area_seconds = processorSeconds() - start;
  start = processorSeconds();
  const agrid::Recognition found = recognise(known, "map", fresh, "map");
  const double seconds = processorSeconds() - start;
  std::size_t kept = 0;
  for (const agrid::AreaTag& tag : known.areas) kept += findTag(found.knowledge, tag.id) ? 1 : 0;
  std::printf(
      "%.0f million pixels: %.2f s to find the areas, %.3f s to recognise them; %zu of %zu "
      "areas and %zu doors\n",
      1e-6 * side * side, area_seconds, seconds, kept, known.areas.size(), known.doors.size());
}

/// From "MAJORITY,MIN_SHARE,MIN_GIVEN_SHARE[,MIN_RETURN_SHARE]".
Variant readVariant(const std::string& word) {
  Variant variant;
  if (std::sscanf(word.c_str(), "%lf,%lf,%lf,%lf", &variant.majority, &variant.params.min_share,
                  &variant.params.min_given_share, &variant.params.min_return_share) < 3) {
    throw std::runtime_error("a variant is MAJORITY,MIN_SHARE,MIN_GIVEN_SHARE[,MIN_RETURN_SHARE]");
  }
  return variant;
}

Request readRequest(int argc, char** argv) {
  Request request;
  std::vector<Variant> variants;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--losses") {
      request.losses = true;
    } else if (word == "--large") {
      request.large = true;
    } else if (i + 1 == argc) {
      throw std::runtime_error(
          "usage: agrid_identity [--shared DIR] [--steps N] [--offices N] "
          "[--only NAME] [--variant M,S,G]... [--large] [--losses]");
    } else if (word == "--shared") {
      request.shared = argv[++i];
    } else if (word == "--only") {
      request.only = argv[++i];
    } else if (word == "--steps") {
      request.steps = std::atoi(argv[++i]);
    } else if (word == "--offices") {
      request.offices = std::atoi(argv[++i]);
    } else if (word == "--variant") {
      variants.push_back(readVariant(argv[++i]));
    } else {
      throw std::runtime_error("unknown option " + word);
    }
  }
  if (!variants.empty()) request.variants = variants;
  return request;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Request request = readRequest(argc, argv);
    printHeader();
    printReplays(request, agrid::bench::Seeing::kDisc, "disc");
    printReplays(request, agrid::bench::Seeing::kLaser, "laser");
    printOffices(request);
    if (request.large) printCost(5000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "agrid_identity: %s\n", error.what());
    return 1;
  }
  return 0;
}

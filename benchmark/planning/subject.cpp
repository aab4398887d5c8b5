// SPDX-License-Identifier: BSD-3-Clause
#include "planning/subject.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <stdexcept>

namespace agrid::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kNearest = 50;      // px
constexpr int kTriesPerPair = 1000;  // where obstacles and other components are hit instead

/// Numbers that are the same with every standard library.
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : random_(seed) {}
  double share() { return static_cast<double>(random_()) / 4294967296.0; }

  Point2 pixel(const Ground& ground) {
    const double x = std::floor(share() * ground.width);
    return {x, std::floor(share() * ground.height)};
  }
  /// Of the free ones.
  Point2 freePixel(const Ground& ground) {
    for (;;) {
      const Point2 p = pixel(ground);
      if (ground.componentAt(p) != 0) return p;
    }
  }
  Point2 near(const Point2& p, double farthest) {
    const double distance = kNearest * std::pow(farthest / kNearest, share());
    const double angle = 2 * M_PI * share();
    return {std::round(p.x() + distance * std::cos(angle)),
            std::round(p.y() + distance * std::sin(angle))};
  }

 private:
  std::mt19937 random_;
};

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

void requireFree(const Ground& ground) {
  const bool any = std::any_of(ground.free.begin(), ground.free.end(), [](auto f) { return f; });
  if (!any) throw std::runtime_error("no pixel of the map is free for the robot");
}

}  // namespace

std::vector<Subject> mapsWithPairs(const std::string& shared) {
  std::vector<Subject> subjects;
  const fs::path pairs = fs::path(shared) / "bench" / "planning_pairs";
  const fs::path maps = fs::path(shared) / "maps" / "bormann";
  if (fs::is_directory(pairs)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(pairs)) {
      if (entry.path().extension() != ".csv") continue;
      const std::string name = entry.path().stem().string();
      subjects.push_back({name, (maps / (name + ".yaml")).string(),
                          (maps / (name + ".png")).string(), entry.path().string()});
    }
  }
  if (subjects.empty()) throw std::runtime_error(pairs.string() + ": no pairs");
  std::sort(subjects.begin(), subjects.end(),
            [](const Subject& a, const Subject& b) { return a.name < b.name; });
  return subjects;
}

Subject generatedOffice(const std::string& shared, const std::string& directory, int size) {
  const std::string name = "office_" + std::to_string(size);
  fs::create_directories(directory);
  const fs::path image = fs::path(directory) / (name + ".pgm");
  const fs::path yaml = fs::path(directory) / (name + ".yaml");
  if (!fs::exists(image)) {
    const fs::path unfinished = image.string() + ".part";
    const std::string command = "/usr/bin/python3 " +
                                quoted(shared + "/tools/generate_office_map.py") + " " +
                                std::to_string(size) + " 7 " + quoted(unfinished.string()) + " >&2";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    fs::rename(unfinished, image);
  }
  std::ofstream(yaml) << "image: " << image.filename().string()
                      << "\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
                         "occupied_thresh: 0.65\nfree_thresh: 0.0197\n";
  return {name, yaml.string(), image.string(), ""};
}

std::vector<tools::Pair> drawPairs(const Ground& ground, int count, std::uint32_t seed) {
  requireFree(ground);
  Draw draw(seed);
  const double farthest = std::hypot(ground.width, ground.height);
  std::vector<tools::Pair> pairs;
  for (int tries = count * kTriesPerPair; tries > 0 && pairs.size() < std::size_t(count); --tries) {
    const Point2 start = draw.freePixel(ground);
    const Point2 goal = pairs.size() % 2 == 0 ? draw.pixel(ground) : draw.near(start, farthest);
    if (!ground.connects(start, goal)) continue;
    pairs.push_back({std::to_string(pairs.size()), start, goal, std::nullopt});
  }
  return pairs;
}

std::vector<tools::Pair> drawSeparatedPairs(const Ground& ground, int count, std::uint32_t seed) {
  requireFree(ground);
  Draw draw(seed);
  std::vector<tools::Pair> pairs;
  for (int tries = count * kTriesPerPair; tries > 0 && pairs.size() < std::size_t(count); --tries) {
    const Point2 start = draw.freePixel(ground);
    const Point2 goal = draw.freePixel(ground);
    if (ground.connects(start, goal)) continue;
    pairs.push_back({"n" + std::to_string(pairs.size()), start, goal, std::nullopt});
  }
  return pairs;
}

}  // namespace agrid::bench

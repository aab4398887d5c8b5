// SPDX-License-Identifier: BSD-3-Clause
// Properties on drawn offices, with areas as they are found.
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"
#include "agrid/evaluation/perturbation.h"
#include "agrid/identity/recognition.h"
#include "agrid/map/map_io.h"
#include "agrid/pipeline.h"

namespace agrid {
namespace {

SemanticMap fresh(const OccupancyMap& map, const Knowledge& doors = {}) {
  return annotate(extractStructure(std::make_shared<const OccupancyMap>(map), {}), doors, {});
}

Office office(std::uint32_t seed) {
  OfficeParams params;
  params.size = 300;
  params.seed = seed;
  return generateOffice(params);
}

/// What is known after a first map, every second area and every third door named by a person.
Knowledge firstKnowledge(const SemanticMap& map) {
  Knowledge known = recognise({}, "", map, "map").knowledge;
  for (AreaTag& tag : known.areas) {
    if (static_cast<int>(tag.id) % 2 != 0) continue;
    tag.name = "room " + std::to_string(static_cast<int>(tag.id));
    tag.source = TagSource::kManual;
  }
  for (DoorTag& tag : known.doors) {
    if (static_cast<int>(tag.id) % 3 == 0) tag.source = TagSource::kManual;
  }
  return known;
}

/// The map with a part of it unknown, on pixels that lie otherwise.
OccupancyMap partOf(const OccupancyGrid& grid, std::mt19937& random) {
  const int side = grid.geometry.width;
  const auto draw = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint32_t>(high - low + 1));
  };
  const int width = draw(side / 3, side);
  const int height = draw(side / 3, side);
  const int left = draw(0, side - width);
  const int bottom = draw(0, side - height);
  OccupancyGrid part;
  part.geometry = {
      width, height, grid.geometry.resolution,
      grid.geometry.map_from_image * Pose2{Point2(left, bottom) * grid.geometry.resolution, 0}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      part.values.push_back(grid.values[grid.geometry.index({left + x, bottom + y})]);
    }
  }
  return OccupancyMap(part);
}

std::set<std::uint32_t> idsIn(const Knowledge& known) {
  std::set<std::uint32_t> ids;
  for (const AreaTag& tag : known.areas) ids.insert(static_cast<std::uint32_t>(tag.id));
  return ids;
}

TEST(OfficeIdentity, M19_TheSameMapAgainChangesNothing) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const OccupancyMap map(office(seed).grid);
    const Knowledge known = firstKnowledge(fresh(map));
    const SemanticMap again = fresh(map, doorsFor("map", known, "map"));
    const Recognition found = recognise(known, "map", again, "map");
    EXPECT_TRUE(found.knowledge.areas == known.areas) << "seed " << seed;
    EXPECT_TRUE(found.knowledge.pending.empty()) << "seed " << seed;
    ASSERT_EQ(found.knowledge.doors.size(), known.doors.size()) << "seed " << seed;
    for (std::size_t i = 0; i < known.doors.size(); ++i) {
      EXPECT_EQ(found.knowledge.doors[i].id, known.doors[i].id) << "seed " << seed;
      EXPECT_EQ(found.knowledge.doors[i].name, known.doors[i].name) << "seed " << seed;
    }
  }
}

TEST(OfficeIdentity, TagsOfARecognisedMapFindTheirAreas) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const OccupancyMap map(office(seed).grid);
    const Knowledge known = firstKnowledge(fresh(map));
    const OccupancyMap other = noisy(map, seed);
    const SemanticMap changed = fresh(other, doorsFor("map", known, "map"));
    const Recognition found = recognise(known, "map", changed, "map");
    ASSERT_EQ(found.knowledge.areas.size(), changed.area_map.areas.size());
    const SemanticMap tagged = retag(changed, found.knowledge);
    ASSERT_EQ(tagged.area_map.areas.size(), found.knowledge.areas.size());
    for (std::size_t i = 0; i < tagged.area_map.areas.size(); ++i) {
      EXPECT_EQ(tagged.area_map.areas[i].id, found.knowledge.areas[i].id) << "seed " << seed;
      EXPECT_EQ(tagged.area_map.areas[i].name, found.knowledge.areas[i].name) << "seed " << seed;
    }
    ASSERT_EQ(tagged.area_map.doors.size(), found.knowledge.doors.size()) << "seed " << seed;
    for (std::size_t i = 0; i < tagged.area_map.doors.size(); ++i) {
      EXPECT_EQ(tagged.area_map.doors[i].id, found.knowledge.doors[i].id) << "seed " << seed;
    }
    EXPECT_EQ(tagged.knowledge.pending.size(), found.knowledge.pending.size()) << "seed " << seed;
  }
}

TEST(OfficeIdentity, M21_NamesStayOnTheirRoomsOnPartsOfTheMap) {
  std::mt19937 random(3);
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Office drawn = office(seed);
    const OccupancyMap whole(drawn.grid);
    const SemanticMap first = fresh(whole);
    Knowledge known = firstKnowledge(first);
    std::map<std::string, Point2> place;
    for (const AreaTag& tag : known.areas) {
      if (tag.source == TagSource::kManual) place[tag.name] = tag.seed_map;
    }
    for (int step = 0; step < 8; ++step) {
      const SemanticMap part = fresh(partOf(drawn.grid, random), doorsFor("map", known, "map"));
      known = recognise(known, "map", part, "map").knowledge;
      std::size_t seen = 0;
      for (const AreaTag& tag : known.areas) {
        if (tag.source != TagSource::kManual) continue;
        ++seen;
        const Area* there = areaAt(part, place.at(tag.name));
        if (there == nullptr) continue;  // of the room a part is seen without its first seed
        EXPECT_EQ(areaAt(part, tag.seed_map), there)
            << "seed " << seed << " step " << step << " " << tag.name;
      }
      std::size_t waiting = 0;
      for (const PendingTag& p : known.pending) waiting += kindOf(p.tag) == TagKind::kArea ? 1 : 0;
      EXPECT_EQ(seen + waiting, place.size()) << "no name is lost";
    }
    const SemanticMap again = fresh(whole, doorsFor("map", known, "map"));
    known = recognise(known, "map", again, "map").knowledge;
    std::size_t back = 0;
    for (const AreaTag& tag : known.areas) back += tag.source == TagSource::kManual ? 1 : 0;
    EXPECT_GE(10 * back, 8 * place.size()) << "seed " << seed;
  }
}

TEST(OfficeIdentity, IdsAreNeverUsedTwiceWhateverMapsCome) {
  std::mt19937 random(7);
  Knowledge known;
  std::string frame;
  std::set<std::uint32_t> gone;
  for (int step = 0; step < 20; ++step) {
    const Office drawn = office(1 + static_cast<std::uint32_t>(random() % 3));
    const std::string fresh_frame = random() % 4 == 0 ? "other" : "map";
    const SemanticMap part = fresh(partOf(drawn.grid, random), doorsFor(fresh_frame, known, frame));
    const std::set<std::uint32_t> before = idsIn(known);
    const std::uint32_t first_new = known.next_ids.area;
    known = recognise(known, frame, part, fresh_frame).knowledge;
    const std::set<std::uint32_t> after = idsIn(known);
    EXPECT_EQ(after.size(), part.area_map.areas.size());
    for (const std::uint32_t id : after) {
      EXPECT_EQ(gone.count(id), 0U) << "step " << step;
      EXPECT_TRUE(before.count(id) > 0 || id >= first_new) << "step " << step;
      EXPECT_LT(id, known.next_ids.area);
    }
    for (const std::uint32_t id : before) {
      if (after.count(id) == 0) gone.insert(id);
    }
    frame = fresh_frame;
  }
  EXPECT_GT(gone.size(), 20U);
}

// a real robot's map in halves of growing width, new noise in each
TEST(OfficeIdentity, AGrowingMapKeepsItsIds) {
  const std::string file = std::string(AGRID_SHARED) + "/maps/real/kth/map.yaml";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no map at " << file;
  const OccupancyGrid grid = loadMap(file).grid;
  const auto rows = [&](int height) {
    OccupancyGrid part = grid;
    part.geometry.height = height;
    part.values.resize(part.geometry.pixelCount());
    return noisy(OccupancyMap(part), static_cast<std::uint32_t>(height));
  };
  Knowledge known;
  std::size_t kept = 0;
  std::size_t all = 0;
  for (int height = 300; height <= grid.geometry.height; height += 40) {
    const SemanticMap map = fresh(rows(height));
    const Knowledge now = recognise(known, "map", map, "map").knowledge;
    for (const AreaTag& tag : known.areas) kept += findTag(now, tag.id) != nullptr ? 1 : 0;
    all += known.areas.size();
    known = now;
  }
  EXPECT_GT(all, 100U);
  EXPECT_GE(100 * kept, 97 * all) << kept << " of " << all;
}

}  // namespace
}  // namespace agrid

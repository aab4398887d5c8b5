// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/map/map_io.h"

#include <array>
#include <chrono>
#include <random>

#include <gtest/gtest.h>

#include "support/map_files.h"
#include "support/png_file.h"

namespace agrid {
namespace {

using test::MapFolder;
using test::mapYaml;
using test::PngColour;
using test::PngFile;

OccupancyGrid randomGrid(std::mt19937& random, double yaw) {
  std::uniform_real_distribution<double> metres(-1000, 1000);
  std::uniform_real_distribution<float> side(0.001f, 10);
  OccupancyGrid grid;
  grid.geometry.width = static_cast<int>(random() % 40 + 1);
  grid.geometry.height = static_cast<int>(random() % 40 + 1);
  grid.geometry.resolution = static_cast<double>(side(random));
  grid.geometry.map_from_image = {Point2(metres(random), metres(random)), yaw};
  for (std::size_t i = 0; i < grid.geometry.pixelCount(); ++i) {
    grid.values.push_back(std::array<std::int8_t, 3>{0, 100, -1}[random() % 3]);
  }
  return grid;
}

TEST(MapIo, LoadingWhatWasSavedGivesItBack) {
  std::mt19937 random(11);
  const test::TemporaryFolder folder;
  for (int i = 0; i < 100; ++i) {
    const OccupancyGrid grid = randomGrid(random, 0);
    saveMap(grid, folder.path("m.yaml"));
    const LoadedMap loaded = loadMap(folder.path("m.yaml"));
    EXPECT_EQ(loaded.grid.values, grid.values);
    EXPECT_EQ(OccupancyMap(loaded.grid).digest(), OccupancyMap(grid).digest());
    EXPECT_TRUE(loaded.warnings.empty());
  }
}

TEST(MapIo, TurnedMapsComeBackWithinSinglePrecision) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> angle(-3.14, 3.14);
  const test::TemporaryFolder folder;
  for (int i = 0; i < 100; ++i) {
    const OccupancyGrid grid = randomGrid(random, angle(random));
    saveMap(grid, folder.path("m.yaml"));
    const Pose2 origin = loadMap(folder.path("m.yaml")).grid.geometry.map_from_image;
    EXPECT_NEAR(origin.yaw, grid.geometry.map_from_image.yaw, 4e-7);
    EXPECT_EQ(origin.position, grid.geometry.map_from_image.position);
  }
}

TEST(MapIo, EveryGreyInEveryModeAsTheFormulaSays) {
  std::string pixels;
  for (int grey = 0; grey < 256; ++grey) pixels += static_cast<char>(grey);
  const std::string pgm = "P5\n256 1\n255\n" + pixels;
  const auto trinary = MapFolder(pgm).load().grid.values;
  const auto scale = MapFolder(pgm, mapYaml("mode: scale")).load().grid.values;
  const auto negated = MapFolder(pgm, mapYaml("negate: 1")).load().grid.values;
  for (std::size_t grey = 0; grey < 256; ++grey) {
    const double darkness = (255 - static_cast<double>(grey)) / 255.0;
    const int expected = darkness > 0.65 ? 100 : darkness < 0.196 ? 0 : -1;
    EXPECT_EQ(trinary[grey], expected) << grey;
    EXPECT_EQ(negated[255 - grey], expected) << grey;
    EXPECT_EQ(scale[grey], expected >= 0
                               ? expected
                               : static_cast<int>(1 + 98 * ((darkness - 0.196) / (0.65 - 0.196))));
  }
}

// --- mutations: whatever the bytes, it is a map or a FileError ----------------------------------

std::string mutated(std::string bytes, std::mt19937& random) {
  for (std::size_t count = random() % 4 + 1; count > 0 && !bytes.empty(); --count) {
    const std::size_t where = random() % bytes.size();
    const auto byte = static_cast<char>(random() % 256);
    switch (random() % 6) {
      case 0:
        bytes[where] = byte;
        break;
      case 1:
        bytes[where] = static_cast<char>(bytes[where] ^ (1 << (random() % 8)));
        break;
      case 2:
        bytes.insert(where, random() % 5 + 1, byte);
        break;
      case 3:
        bytes.erase(where, random() % 8 + 1);
        break;
      case 4:
        bytes.insert(where, bytes.substr(random() % bytes.size(), random() % 30));
        break;
      default:
        bytes.resize(where);
    }
  }
  return bytes;
}

std::vector<std::string> smallImages() {
  PngFile grey;
  grey.width = grey.height = 5;
  grey.rows.assign(5, "\1\2\3\4\5");
  PngFile interlaced = grey;
  interlaced.interlaced = true;
  PngFile palette = grey;
  palette.colour = PngColour::kPalette;
  palette.chunks = test::pngChunk("PLTE", "aaabbbcccdddeeefff") + test::pngChunk("tRNS", "ab");
  PngFile rgba;
  rgba.colour = PngColour::kRgba;
  rgba.bit_depth = 16;
  rgba.rows = {"abcdefgh"};
  const std::string bmp = "BM" + std::string(8, '\0') + std::string("\x3E\0\0\0\x28\0\0\0", 8) +
                          std::string("\3\0\0\0\1\0\0\0\1\0\1\0", 12) + std::string(24, '\0') +
                          std::string("\xFF\xFF\xFF\0\0\0\0\0\x60\0\0\0", 12);
  return {test::smallPgm(),    "P2 # c\n3 2\n255\n1 2 3 4 5 6\n",
          "P1\n3 1\n101",      "P4\n9 1\nab",
          "P6\n1 1\n255\nabc", grey.bytes(),
          interlaced.bytes(),  palette.bytes(),
          rgba.bytes(),        bmp};
}

// True if it is a map.
bool survives(const MapFolder& folder) {
  MapFileParams params;
  params.max_pixels = 1e6;
  try {
    const LoadedMap map = folder.load(params);
    EXPECT_EQ(map.grid.values.size(), map.grid.geometry.pixelCount());
    EXPECT_NO_THROW(OccupancyMap{map.grid});
    return true;
  } catch (const FileError& error) {
    EXPECT_GT(std::string(error.what()).size(), folder.path().size());
    return false;
  }
}

template <typename Mutate>
void mutate(const Mutate& mutate_once) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(4);
  int maps = 0;
  int errors = 0;
  for (std::uint32_t seed = 0; seed < 1000 && std::chrono::steady_clock::now() < end; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    ++(mutate_once(random) ? maps : errors);
  }
  EXPECT_GT(errors, 0);
  EXPECT_GT(maps, 0);
}

TEST(MapIo, MutatedImagesAreMapsOrErrors) {
  const std::vector<std::string> images = smallImages();
  for (const std::string& image : images) EXPECT_TRUE(survives(MapFolder(image)));
  const MapFolder folder;
  mutate([&](std::mt19937& random) {
    folder.write("map.img", mutated(images[random() % images.size()], random));
    return survives(folder);
  });
}

TEST(MapIo, MutatedYamlsAreMapsOrErrors) {
  const MapFolder folder;
  const std::string yaml = mapYaml() + "mode: scale\n# c\nx: {a: [1, 'b'], c: \"d\"}\ny: |\n  z\n";
  mutate([&](std::mt19937& random) {
    folder.write("map.yaml", mutated(yaml, random));
    return survives(folder);
  });
}

}  // namespace
}  // namespace agrid

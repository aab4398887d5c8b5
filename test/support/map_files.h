// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "agrid/map/map_io.h"
#include "support/temporary_folder.h"

namespace agrid::test {

using Bytes = std::vector<std::uint8_t>;

inline std::string text(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

/// A small right YAML file but for one line: the line of the same key is replaced, or added.
inline std::string mapYaml(const std::string& line = "") {
  std::string yaml;
  const std::string key = line.substr(0, line.find(':'));
  bool replaced = line.empty();
  for (const char* right : {"image: map.img", "resolution: 0.05", "origin: [-1.5, 2.25, 0]",
                            "negate: 0", "occupied_thresh: 0.65", "free_thresh: 0.196"}) {
    const std::string own(right);
    const bool same = own.substr(0, own.find(':')) == key;
    yaml += (same ? line : own) + "\n";
    replaced = replaced || same;
  }
  return replaced ? yaml : yaml + line + "\n";
}

/// A grey image of one row, free, unknown and occupied.
inline std::string smallPgm() { return "P5\n3 1\n255\n" + std::string("\xFE\xCD\0", 3); }

/// A folder with `map.yaml` and the image `map.img` that it names.
class MapFolder : public TemporaryFolder {
 public:
  explicit MapFolder(const std::string& image = smallPgm(), const std::string& yaml = mapYaml()) {
    write("map.img", image);
    write("map.yaml", yaml);
  }
  LoadedMap load(const MapFileParams& params = {}) const {
    return loadMap(path("map.yaml"), params);
  }
};

/// The grid that an image makes in raw mode: the grey levels as bytes, the lowest row first.
inline Bytes rawValues(const std::string& image) {
  const auto values = MapFolder(image, mapYaml("mode: raw")).load().grid.values;
  return {values.begin(), values.end()};
}

inline std::vector<std::string> warningsOf(const std::string& image) {
  return MapFolder(image).load().warnings;
}

/// Expects that a call fails with a FileError of this code whose text holds `part`.
template <typename Call>
void expectFileError(FileErrorCode code, const std::string& part, const Call& call) {
  try {
    call();
    ADD_FAILURE() << "accepted, expected: " << part;
  } catch (const FileError& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
        << "'" << error.what() << "' does not tell '" << part << "'";
  }
}

inline void expectImageError(const std::string& part, const std::string& image) {
  const MapFolder folder(image);
  expectFileError(FileErrorCode::kImage, part, [&folder] { folder.load(); });
}

}  // namespace agrid::test

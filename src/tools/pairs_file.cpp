// SPDX-License-Identifier: BSD-3-Clause
#include "tools/pairs_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "agrid/map/map_io.h"
#include "tools/arguments.h"

namespace agrid::tools {
namespace {

constexpr std::size_t kMaxIdLength = 64;

std::vector<std::string> fieldsOf(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> fields;
  std::stringstream stream(line + ",");
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

/// Where a file stands, for messages.
struct Place {
  const std::string& path;
  std::size_t line;

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(FileErrorCode::kIo, path + ":" + std::to_string(line) + ": " + what);
  }
};

const std::array<const char*, 5> kColumns{"id", "start_x_px", "start_y_px", "goal_x_px",
                                          "goal_y_px"};

/// Where the values stand in each line.
struct Columns {
  std::array<std::size_t, 5> needed{};
  std::optional<std::size_t> best_known;
};

Columns columnsOf(const std::vector<std::string>& header, const Place& place) {
  Columns columns;
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const auto found = std::find(header.begin(), header.end(), kColumns[i]);
    if (found == header.end()) place.fail(std::string("no column ") + kColumns[i]);
    columns.needed[i] = static_cast<std::size_t>(found - header.begin());
  }
  const auto found = std::find(header.begin(), header.end(), "best_known_length_px");
  if (found != header.end()) {
    columns.best_known = static_cast<std::size_t>(found - header.begin());
  }
  return columns;
}

/// The id becomes a file's name.
bool isPlainId(const std::string& id) {
  return !id.empty() && id.size() <= kMaxIdLength && std::all_of(id.begin(), id.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
  });
}

Pair pairOf(const std::vector<std::string>& fields, const Columns& columns, const Place& place) {
  if (fields.size() <= *std::max_element(columns.needed.begin(), columns.needed.end())) {
    place.fail("has only " + std::to_string(fields.size()) + " fields");
  }
  const auto number = [&](std::size_t i) {
    const std::string& field = fields[columns.needed[i]];
    const auto value = parseNumber(field);
    if (!value) place.fail(std::string(kColumns[i]) + ": '" + field + "' is no number");
    return *value;
  };
  const std::string& id = fields[columns.needed[0]];
  if (!isPlainId(id)) place.fail("id: only letters, digits, '-' and '_', at most 64");
  Pair pair{id, {number(1), number(2)}, {number(3), number(4)}};
  if (columns.best_known && *columns.best_known < fields.size()) {
    pair.best_known_px = parseNumber(fields[*columns.best_known]);
  }
  return pair;
}

}  // namespace

std::vector<Pair> readPairs(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw FileError(FileErrorCode::kPath, path + ": " + std::strerror(errno));
  std::string line;
  if (!std::getline(file, line)) throw FileError(FileErrorCode::kIo, path + ": is empty");
  Place place{path, 1};
  const auto columns = columnsOf(fieldsOf(line), place);
  std::vector<Pair> pairs;
  std::set<std::string> ids;
  while (std::getline(file, line)) {
    ++place.line;
    if (line.empty() || line == "\r") continue;
    pairs.push_back(pairOf(fieldsOf(line), columns, place));
    if (!ids.insert(pairs.back().id).second) place.fail("id " + pairs.back().id + " again");
  }
  if (file.bad()) throw FileError(FileErrorCode::kIo, path + ": cannot be read");
  return pairs;
}

}  // namespace agrid::tools

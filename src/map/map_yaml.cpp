// SPDX-License-Identifier: BSD-3-Clause
#include "map/map_yaml.h"

#include <algorithm>
#include <cctype>
#include <locale>
#include <optional>
#include <sstream>

#include "agrid/map/map_io.h"
#include "map/printable.h"
#include "map/yaml_entries.h"

namespace agrid {
namespace {

using Kind = YamlValue::Kind;

struct Range {
  double least;
  double most;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  const auto last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// A decimal number as a C++ stream reads it under the classic locale, whatever the locale is.
std::optional<double> numberOf(const std::string& untrimmed) {
  std::string text = trimmed(untrimmed);
  if (!text.empty() && text[0] == '+') text.erase(0, 1);
  const std::size_t digits = text.rfind('-', 0) == 0 ? 1 : 0;
  // libraries differ over "inf" and "nan"
  if (text.size() <= digits ||
      (text[digits] != '.' && !std::isdigit(static_cast<unsigned char>(text[digits])))) {
    return std::nullopt;
  }
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0;
  if (!(stream >> number) || stream.peek() != std::istringstream::traits_type::eof()) {
    return std::nullopt;
  }
  return number;
}

std::string shown(double number) {
  std::string text = std::to_string(number);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string found(const YamlValue& value) {
  switch (value.kind) {
    case Kind::kNull:
      return "found nothing";
    case Kind::kScalar:
      return "found '" + printable(value.scalars[0].substr(0, 64)) + "'";
    case Kind::kSequence:
      return "found a list of " + std::to_string(value.scalars.size());
    case Kind::kOther:
      break;
  }
  return "found a nested value";
}

// Gives out the entries by key, in the types they must have.
class Reader {
 public:
  Reader(std::vector<YamlEntry> entries, std::string name)
      : entries_(std::move(entries)), name_(std::move(name)) {}

  const YamlEntry* find(const std::string& key) const {
    const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                    [&key](const YamlEntry& e) { return e.key == key; });
    return entry == entries_.end() ? nullptr : &*entry;
  }

  std::string text(const std::string& key) const {
    const YamlEntry& entry = required(key);
    if (entry.value.kind != Kind::kScalar) refuse(entry, "must be a text");
    if (entry.value.scalars[0].empty()) refuse(entry, "must not be empty");
    return entry.value.scalars[0];
  }

  double number(const std::string& key, Range range) const {
    const YamlEntry& entry = required(key);
    if (entry.value.kind != Kind::kScalar) refuse(entry, "must be a number");
    return inRange(entry, entry.value.scalars[0], range);
  }

  bool zeroOrOne(const std::string& key) const {
    const YamlEntry& entry = required(key);
    const std::string allowed = "must be 0 or 1";
    if (entry.value.kind != Kind::kScalar) refuse(entry, allowed);
    const std::string text = trimmed(entry.value.scalars[0]);
    if (text != "0" && text != "1") refuse(entry, allowed);
    return text == "1";
  }

  std::array<double, 3> triple(const std::string& key, std::array<Range, 3> ranges) const {
    const YamlEntry& entry = required(key);
    if (entry.value.kind != Kind::kSequence || entry.value.scalars.size() != 3) {
      refuse(entry, "must be a list of 3 numbers: x, y, yaw");
    }
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) {
      numbers[i] = inRange(entry, entry.value.scalars[i], ranges[i]);
    }
    return numbers;
  }

  [[noreturn]] void refuse(const YamlEntry& entry, const std::string& allowed) const {
    const YamlMark& mark = entry.mark;
    throw FileError(FileErrorCode::kYaml, name_ + ":" + std::to_string(mark.line) + ":" +
                                              std::to_string(mark.column) + ": " + entry.key + " " +
                                              allowed + ", " + found(entry.value));
  }

  std::vector<std::string> warningsOfUnknownKeys() const {
    static const std::array<const char*, 7> kKeys = {
        "image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"};
    std::vector<std::string> warnings;
    for (const YamlEntry& entry : entries_) {
      if (std::find(kKeys.begin(), kKeys.end(), entry.key) != kKeys.end()) continue;
      warnings.push_back("line " + std::to_string(entry.mark.line) + ": unknown key '" +
                         printable(entry.key.substr(0, 64)) + "' left out");
    }
    return warnings;
  }

 private:
  const YamlEntry& required(const std::string& key) const {
    const YamlEntry* entry = find(key);
    if (entry == nullptr) {
      throw FileError(FileErrorCode::kYaml, name_ + ": key '" + key + "' is missing");
    }
    return *entry;
  }

  double inRange(const YamlEntry& entry, const std::string& text, Range range) const {
    const auto number = numberOf(text);
    if (number && *number >= range.least && *number <= range.most) return *number;
    refuse(entry, std::string(number ? "must be" : "must be a number") + " in [" +
                      shown(range.least) + ", " + shown(range.most) + "], '" +
                      printable(text.substr(0, 64)) + "' is not");
  }

  std::vector<YamlEntry> entries_;
  std::string name_;
};

PixelMode modeOf(const Reader& reader) {
  const YamlEntry* entry = reader.find("mode");
  if (entry == nullptr || entry->value.kind == Kind::kNull) return PixelMode::kTrinary;
  const std::string text = entry->value.kind == Kind::kScalar ? entry->value.scalars[0] : "";
  if (text == "trinary") return PixelMode::kTrinary;
  if (text == "scale") return PixelMode::kScale;
  if (text == "raw") return PixelMode::kRaw;
  reader.refuse(*entry, "must be trinary, scale or raw");
}

}  // namespace

MapYaml parseMapYaml(const std::string& text, const std::string& name) {
  constexpr Range kPosition{-1e6, 1e6};
  // Beyond a few turns single precision, in which map_server computes, has no use for an angle.
  constexpr Range kYaw{-1e4, 1e4};
  const Reader reader(yamlEntries(text, name), name);
  MapYaml yaml;
  yaml.image = reader.text("image");
  yaml.resolution = reader.number("resolution", {0.001, 10});
  yaml.origin = reader.triple("origin", {kPosition, kPosition, kYaw});
  yaml.rule.negate = reader.zeroOrOne("negate");
  yaml.rule.occupied_thresh = reader.number("occupied_thresh", {0, 1});
  yaml.rule.free_thresh = reader.number("free_thresh", {0, 1});
  yaml.rule.mode = modeOf(reader);
  if (!(yaml.rule.free_thresh < yaml.rule.occupied_thresh)) {
    reader.refuse(*reader.find("free_thresh"), "must be less than occupied_thresh");
  }
  yaml.warnings = reader.warningsOfUnknownKeys();
  return yaml;
}

}  // namespace agrid

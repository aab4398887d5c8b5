// SPDX-License-Identifier: BSD-3-Clause
#include "map/yaml_entries.h"

#include <algorithm>
#include <sstream>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "agrid/map/map_io.h"
#include "map/printable.h"

namespace agrid {
namespace {

constexpr int kDeepest = 16;

[[noreturn]] void refuse(const std::string& name, const YAML::Mark& mark, const std::string& what) {
  throw FileError(FileErrorCode::kYaml, name + ":" + std::to_string(mark.line + 1) + ":" +
                                            std::to_string(mark.column + 1) + ": " + what);
}

// Collects the entries from the parser's events: no tree is built, and what is refused is refused
// before the parser, which recurses, goes deeper.
class EntryCollector : public YAML::EventHandler {
 public:
  explicit EntryCollector(const std::string& name) : name_(name) {}

  std::vector<YamlEntry> takeEntries() { return std::move(entries_); }
  bool hasDocument() const { return has_document_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (has_document_) refuse(name_, mark, "a second document; a map has one");
    has_document_ = true;
  }
  void OnDocumentEnd() override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(name_, mark, "aliases are not supported in a map");
  }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    if (depth_ == 1 && !expects_value_) refuse(name_, mark, "a key is missing");
    add(mark, YamlValue::Kind::kNull, "");
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                const std::string& value) override {
    add(mark, YamlValue::Kind::kScalar, value);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(mark, YamlValue::Kind::kSequence);
  }
  void OnSequenceEnd() override { --depth_; }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    if (depth_ == 0) {
      depth_ = 1;
    } else {
      open(mark, YamlValue::Kind::kOther);
    }
  }
  void OnMapEnd() override { --depth_; }

 private:
  void open(const YAML::Mark& mark, YamlValue::Kind kind) {
    if (depth_ == 0) refuse(name_, mark, "not a mapping of keys to values");
    if (depth_ >= kDeepest) refuse(name_, mark, "nested too deeply");
    if (depth_ == 1) {
      if (!expects_value_) refuse(name_, mark, "a key is not a scalar");
      setValue(mark, kind);
    } else {
      entries_.back().value.kind = YamlValue::Kind::kOther;
    }
    ++depth_;
  }

  void add(const YAML::Mark& mark, YamlValue::Kind kind, const std::string& text) {
    if (depth_ == 0) refuse(name_, mark, "not a mapping of keys to values");
    if (depth_ == 1 && !expects_value_) return addKey(mark, text);
    if (depth_ == 1) setValue(mark, kind);
    if (depth_ == 2 && kind == YamlValue::Kind::kNull) {
      entries_.back().value.kind = YamlValue::Kind::kOther;
    }
    if (depth_ <= 2) entries_.back().value.scalars.push_back(text);
  }

  void addKey(const YAML::Mark& mark, const std::string& key) {
    const auto same = std::find_if(entries_.begin(), entries_.end(),
                                   [&key](const YamlEntry& entry) { return entry.key == key; });
    if (same != entries_.end()) {
      refuse(name_, mark,
             "duplicate key '" + printable(key) + "', first in line " +
                 std::to_string(same->mark.line));
    }
    entries_.push_back({key, {mark.line + 1, mark.column + 1}, {}});
    expects_value_ = true;
  }

  void setValue(const YAML::Mark& mark, YamlValue::Kind kind) {
    entries_.back().value.kind = kind;
    entries_.back().value.mark = {mark.line + 1, mark.column + 1};
    expects_value_ = false;
  }

  const std::string& name_;
  std::vector<YamlEntry> entries_;
  int depth_ = 0;  // of open collections
  bool has_document_ = false;
  bool expects_value_ = false;
};

}  // namespace

std::vector<YamlEntry> yamlEntries(const std::string& text, const std::string& name) {
  EntryCollector collector(name);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(collector)) {
    }
  } catch (const YAML::Exception& error) {
    refuse(name, error.mark, printable(error.msg));
  }
  if (!collector.hasDocument()) refuse(name, YAML::Mark(), "empty: no map in it");
  return collector.takeEntries();
}

}  // namespace agrid

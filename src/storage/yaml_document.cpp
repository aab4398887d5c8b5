// SPDX-License-Identifier: BSD-3-Clause
#include "storage/yaml_document.h"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include <yaml-cpp/binary.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "agrid/storage.h"
#include "map/printable.h"
#include "storage/flow_text.h"

namespace agrid {
namespace {

using Kind = StoredNode::Kind;

constexpr std::size_t kDeepest = 8;

[[noreturn]] void refuse(const std::string& name, int line, const std::string& what) {
  throw StorageError(StorageErrorCode::kCorrupt, name + ":" + std::to_string(line) + ": " + what);
}

/// Collects nodes from the parser's events. What is refused is refused before the parser, which
/// recurses, goes deeper.
class NodeCollector : public YAML::EventHandler {
 public:
  NodeCollector(const std::string& name, const NodeSink& sink) : name_(name), sink_(sink) {}

  bool hasDocument() const { return has_document_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (has_document_) refuse(name_, mark.line + 1, "a second document; there must be one");
    has_document_ = true;
  }
  void OnDocumentEnd() override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(name_, mark.line + 1, "aliases are not supported");
  }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    scalar(mark, Kind::kNull, std::string());
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    if (tag != "tag:yaml.org,2002:binary") return scalar(mark, Kind::kScalar, value);
    const auto bytes = YAML::DecodeBase64(value);
    if (bytes.empty() && !value.empty()) refuse(name_, mark.line + 1, "not base64");
    scalar(mark, Kind::kScalar, std::string(bytes.begin(), bytes.end()));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(mark, Kind::kSequence);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    open(mark, Kind::kMapping);
  }
  void OnMapEnd() override { close(); }

 private:
  /// A collection that is not complete, with the key that waits for its value.
  struct Open {
    StoredNode node;
    std::optional<std::string> key;
    std::set<std::string> keys;
  };

  void scalar(const YAML::Mark& mark, Kind kind, const std::string& text) {
    if (open_.empty()) refuse(name_, mark.line + 1, "not a mapping of keys to values");
    Open& top = open_.back();
    if (top.node.kind == Kind::kMapping && !top.key) {
      if (kind == Kind::kNull) refuse(name_, mark.line + 1, "a key is missing");
      return addKey(mark, text);
    }
    StoredNode node;
    node.kind = kind;
    node.line = mark.line + 1;
    node.text = text;
    add(std::move(node));
  }

  void addKey(const YAML::Mark& mark, const std::string& key) {
    Open& top = open_.back();
    if (!top.keys.insert(key).second) {
      refuse(name_, mark.line + 1, "key '" + printable(key) + "' is there twice");
    }
    top.key = key;
  }

  void open(const YAML::Mark& mark, Kind kind) {
    if (open_.empty() && kind != Kind::kMapping) {
      refuse(name_, mark.line + 1, "not a mapping of keys to values");
    }
    if (open_.size() >= kDeepest) refuse(name_, mark.line + 1, "nested too deeply");
    if (!open_.empty() && open_.back().node.kind == Kind::kMapping && !open_.back().key) {
      refuse(name_, mark.line + 1, "a key is not a text");
    }
    Open opened;
    opened.node.kind = kind;
    opened.node.line = mark.line + 1;
    open_.push_back(std::move(opened));
  }

  void close() {
    StoredNode node = std::move(open_.back().node);
    open_.pop_back();
    if (open_.empty()) return;
    if (open_.size() == 1 && node.kind == Kind::kSequence) {
      open_.back().key.reset();  // its items were given out
    } else {
      add(std::move(node));
    }
  }

  void add(StoredNode&& node) {
    Open& top = open_.back();
    if (top.key) node.key = std::move(*top.key);
    top.key.reset();
    const bool is_entry = open_.size() == 1;
    const bool is_item = open_.size() == 2 && top.node.kind == Kind::kSequence;
    if (is_entry) {
      sink_(std::string(), std::move(node));
    } else if (is_item) {
      sink_(*open_.front().key, std::move(node));
    } else {
      top.node.children.push_back(std::move(node));
    }
  }

  const std::string& name_;
  const NodeSink& sink_;
  std::vector<Open> open_;
  bool has_document_ = false;
};

bool isBlank(std::string_view line) { return line.empty() || line[0] == '#'; }

void moveDown(StoredNode& node, int lines) {
  node.line += lines;
  for (StoredNode& child : node.children) moveDown(child, lines);
}

/// Reads line by line. A list's item that is written otherwise is read on its own: it ends where
/// the next one begins or the lines are no longer indented. If that cuts something, what is left is
/// no YAML.
class OwnReader {
 public:
  OwnReader(std::string_view text, const NodeSink& sink) : rest_(text), sink_(sink) {}

  /// @return false if the text is laid out otherwise
  bool read() {
    while (!rest_.empty()) {
      const auto line = takeLine();
      if (!line) return false;
      if (isBlank(*line)) continue;
      const bool is_item = line->substr(0, kItem.size()) == kItem;
      if (!(is_item ? readItem(*line) : readKey(*line))) return false;
    }
    return !waits_for_item_ && !keys_.empty();
  }

 private:
  static constexpr std::string_view kItem = "  - ";
  static constexpr int kMostOdd = 1000;  // beyond it reading all at once is faster

  std::optional<std::string_view> nextLine() const {
    const std::size_t end = rest_.find('\n');
    return end == std::string_view::npos ? std::nullopt : std::optional(rest_.substr(0, end));
  }

  std::optional<std::string_view> takeLine() {
    const auto line = nextLine();
    if (!line) return std::nullopt;
    rest_.remove_prefix(line->size() + 1);
    ++number_;
    return line;
  }

  bool readItem(std::string_view line) {
    if (section_.empty()) return false;
    waits_for_item_ = false;
    auto item = parseFlow(line.substr(kItem.size()), number_);
    if (!item) return ++odd_ <= kMostOdd && readOddItem(line);
    sink_(section_, std::move(*item));
    return true;
  }

  bool readOddItem(std::string_view line) {
    const int lines_before = number_ - 2;
    std::string text = "item:\n" + std::string(line) + "\n";
    for (auto next = nextLine(); next; next = nextLine()) {
      const bool goes_on = isBlank(*next) || (next->front() == ' ' && next->substr(0, 4) != kItem);
      if (!goes_on) break;
      text += std::string(*next) + "\n";
      takeLine();
    }
    text += "end:\n";
    std::vector<StoredNode> read;
    try {
      readYaml(text, "",
               [&](const std::string&, StoredNode&& node) { read.push_back(std::move(node)); });
    } catch (const StorageError&) {
      return false;  // reading the whole tells what is wrong
    }
    // what has no end in these lines has taken theirs
    if (read.size() != 2 || read.back().key != "end") return false;
    moveDown(read.front(), lines_before);
    sink_(section_, std::move(read.front()));
    return true;
  }

  bool readKey(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || waits_for_item_) return false;
    section_ = line.substr(0, colon);
    const bool is_plain = std::all_of(section_.begin(), section_.end(),
                                      [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
    if (!is_plain || section_.empty() || !keys_.insert(section_).second) return false;
    if (colon + 1 == line.size()) return waits_for_item_ = true;
    auto value = parseFlow(line.substr(std::min(colon + 2, line.size())), number_);
    if (!value || line[colon + 1] != ' ') return false;
    value->key = std::exchange(section_, std::string());
    if (value->kind != Kind::kSequence) {
      sink_(std::string(), std::move(*value));
    } else {
      for (StoredNode& item : value->children) sink_(value->key, std::move(item));
    }
    return true;
  }

  std::string_view rest_;
  const NodeSink& sink_;
  std::string section_;
  std::set<std::string> keys_;
  bool waits_for_item_ = false;
  int number_ = 0;
  int odd_ = 0;
};

}  // namespace

void readYaml(const std::string& text, const std::string& name, const NodeSink& sink) {
  NodeCollector collector(name, sink);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(collector)) {
    }
  } catch (const YAML::Exception& error) {
    refuse(name, error.mark.line + 1, printable(error.msg));
  }
  if (!collector.hasDocument()) refuse(name, 1, "nothing in it");
}

bool readOwnYaml(const std::string& text, const NodeSink& sink) {
  return OwnReader(text, sink).read();
}

}  // namespace agrid

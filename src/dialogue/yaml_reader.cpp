// SPDX-License-Identifier: BSD-3-Clause
#include "dialogue/yaml_reader.h"

#include <set>
#include <utility>

#include "agrid/map/map_io.h"
#include "map/printable.h"

namespace agrid::dialogue {
namespace {

std::string at(const std::string& name, const YAML::Mark& mark) {
  if (mark.is_null()) return name + ": ";
  return name + ":" + std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1) + ": ";
}

}  // namespace

YamlReader::YamlReader(const std::string& text, std::string name) : name_(std::move(name)) {
  try {
    root_.node = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw FileError(FileErrorCode::kYaml, at(name_, error.mark) + printable(error.msg));
  }
  if (!root_.node.IsMap()) refuse(root_, "not a mapping of keys to values");
}

std::vector<YamlPair> YamlReader::entries(const YamlPlace& mapping) const {
  if (!mapping.node.IsMap()) refuse(mapping, "must be a mapping of keys to values");
  std::vector<YamlPair> entries;
  std::set<std::string> keys;
  for (const auto& entry : mapping.node) {
    if (!entry.first.IsScalar()) refuse({entry.first, mapping.path}, "a key is not a text");
    const std::string& key = entry.first.Scalar();
    const std::string path = mapping.path + (mapping.path.empty() ? "" : "/") + key;
    if (!keys.insert(key).second) refuse({entry.first, path}, "is there twice");
    entries.push_back({key, {entry.first, path}, {entry.second, path}});
  }
  return entries;
}

std::string YamlReader::text(const YamlPlace& scalar) const {
  if (!scalar.node.IsScalar()) refuse(scalar, "must be a text");
  if (scalar.node.Scalar().empty()) refuse(scalar, "must not be empty");
  return scalar.node.Scalar();
}

std::vector<YamlText> YamlReader::texts(const YamlPlace& list) const {
  if (list.node.IsScalar()) return {{text(list), list}};
  if (!list.node.IsSequence()) refuse(list, "must be a text or a list of texts");
  std::vector<YamlText> texts;
  for (const YAML::Node& node : list.node) {
    const YamlPlace place{node, list.path};
    texts.push_back({text(place), place});
  }
  return texts;
}

void YamlReader::refuse(const YamlPlace& place, const std::string& what) const {
  const std::string path = printable(place.path.substr(0, 128));
  throw FileError(FileErrorCode::kYaml,
                  at(name_, place.node.Mark()) + path + (path.empty() ? "" : ": ") + what);
}

}  // namespace agrid::dialogue

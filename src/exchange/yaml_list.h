// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <yaml-cpp/yaml.h>

#include "agrid/geometry/point2.h"

namespace agrid {

/// A YAML (or JSON) file of other people, whose values are checked as they are taken. Each call
/// throws FileError naming the path and the line.
class YamlFile {
 public:
  explicit YamlFile(std::string path) : path_(std::move(path)) {}

  YAML::Node load() const;
  YAML::Node list() const;  ///< load(), if it is a sequence

  static bool has(const YAML::Node& node, const char* key) { return node.IsMap() && node[key]; }
  YAML::Node entry(const YAML::Node& node, const char* key) const;
  double number(const YAML::Node& node) const;  ///< finite
  Point2 point(const YAML::Node& node) const;   ///< [x, y]
  std::string name(const YAML::Node& node) const;

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const;

 private:
  std::string path_;
};

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/yaml_list.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "agrid/map/map_io.h"
#include "agrid/tags/name.h"

namespace agrid {

void YamlFile::fail(const YAML::Mark& mark, const std::string& what) const {
  const std::string line = mark.is_null() ? "" : ":" + std::to_string(mark.line + 1);
  throw FileError(FileErrorCode::kYaml, path_ + line + ": " + what);
}

YAML::Node YamlFile::load() const {
  std::ifstream stream(path_);
  if (!stream) throw FileError(FileErrorCode::kPath, path_ + ": " + std::strerror(errno));
  try {
    return YAML::Load(stream);
  } catch (const YAML::Exception& error) {
    fail(error.mark, error.msg);
  }
}

YAML::Node YamlFile::list() const {
  const YAML::Node node = load();
  if (!node.IsSequence()) fail(node.Mark(), "is no list");
  return node;
}

YAML::Node YamlFile::entry(const YAML::Node& node, const char* key) const {
  if (!node.IsMap()) fail(node.Mark(), std::string("is nothing with a key '") + key + "'");
  const YAML::Node value = node[key];
  if (!value) fail(node.Mark(), std::string("no key '") + key + "'");
  return value;
}

double YamlFile::number(const YAML::Node& node) const {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    fail(node.Mark(), "is no finite number");
  }
  return value;
}

Point2 YamlFile::point(const YAML::Node& node) const {
  if (!node.IsSequence() || node.size() != 2) fail(node.Mark(), "a point is [x, y]");
  Point2 p = Point2::Zero();
  for (std::size_t i = 0; i < 2; ++i) {
    double& value = p[static_cast<Eigen::Index>(i)];
    if (!YAML::convert<double>::decode(node[i], value) || !std::isfinite(value)) {
      fail(node.Mark(), "a point is [x, y], two finite numbers");
    }
  }
  return p;
}

std::string YamlFile::name(const YAML::Node& node) const {
  if (!node.IsScalar()) fail(node.Mark(), "a name is a text");
  const std::string problem = problemOfName(node.Scalar());
  if (!problem.empty()) fail(node.Mark(), problem);
  return node.Scalar();
}

}  // namespace agrid

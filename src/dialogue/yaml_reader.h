// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace agrid::dialogue {

/// A node of a YAML file and the keys that lead to it.
struct YamlPlace {
  YAML::Node node;
  std::string path;
};

/// A key of a mapping and what it leads to.
struct YamlPair {
  std::string key;
  YamlPlace key_place;
  YamlPlace value;
};

/// A text and where it stands.
struct YamlText {
  std::string text;
  YamlPlace place;
};

/// Reads values of one file and says where one is not what it must be.
class YamlReader {
 public:
  /// @throws FileError (kYaml) if the text is not one YAML document that is a mapping
  YamlReader(const std::string& text, std::string name);

  const YamlPlace& root() const { return root_; }

  /// What is in a mapping, in its order; every key once.
  std::vector<YamlPair> entries(const YamlPlace& mapping) const;
  /// A text, which is not empty.
  std::string text(const YamlPlace& scalar) const;
  /// A list of texts, or one alone.
  std::vector<YamlText> texts(const YamlPlace& list) const;

  /// @throws FileError always, with file, line, column and keys in front of `what`
  [[noreturn]] void refuse(const YamlPlace& place, const std::string& what) const;

 private:
  std::string name_;
  YamlPlace root_;
};

}  // namespace agrid::dialogue

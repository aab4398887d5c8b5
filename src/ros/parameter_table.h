// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "agrid_map_ros/parameters.h"

namespace agrid_map_ros {

struct NumberField {
  double* value;
  double low;
  double high;
};

struct IntegerField {
  int* value;
  int low;
  int high;
};

/// The same for what is counted.
struct CountField {
  std::size_t* value;
  int low;
  int high;
};

struct FlagField {
  bool* value;
};

struct TextField {
  std::string* value;
  bool may_be_empty = false;
};

/// A list of points, each a list of two numbers.
struct PolygonField {
  agrid::Polygon* value;
};

/// One word out of a few.
struct ChoiceField {
  std::vector<std::string> words;
  std::function<void(std::size_t)> choose;  ///< called with the word's position
};

/// A parameter's name and where its value goes.
struct ParameterEntry {
  std::string name;
  std::variant<NumberField, IntegerField, CountField, FlagField, TextField, ChoiceField,
               PolygonField>
      field;
};

/// Every parameter there is; the entries point into `parameters`.
std::vector<ParameterEntry> parameterTable(Parameters& parameters);

}  // namespace agrid_map_ros

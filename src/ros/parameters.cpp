// SPDX-License-Identifier: BSD-3-Clause
#include "agrid_map_ros/parameters.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "ros/parameter_table.h"
#include "ros/text.h"
#include "semantic_map/closest_names.h"

namespace agrid_map_ros {
namespace {

using XmlRpc::XmlRpcValue;

constexpr std::size_t kLongestText = 256;  // bytes
constexpr int kMostPoints = 1001;          // of a polygon; one more than any may have

std::string typeName(XmlRpcValue::Type type) {
  switch (type) {
    case XmlRpcValue::TypeBoolean:
      return "a flag";
    case XmlRpcValue::TypeInt:
      return "an integer";
    case XmlRpcValue::TypeDouble:
      return "a number";
    case XmlRpcValue::TypeString:
      return "a text";
    case XmlRpcValue::TypeArray:
      return "a list";
    case XmlRpcValue::TypeStruct:
      return "a namespace";
    default:
      return "of an unknown type";
  }
}

void requireType(XmlRpcValue& value, XmlRpcValue::Type type) {
  if (value.getType() != type) {
    throw std::invalid_argument("is " + typeName(value.getType()) + ", must be " + typeName(type));
  }
}

/// Stores a value where its entry says; one overload for each kind of field.
struct Store {
  XmlRpcValue& value;

  void operator()(const NumberField& field) const {
    const double read = number(value);
    requireRange(read, field.low, field.high);
    *field.value = read;
  }
  void operator()(const IntegerField& field) const {
    requireType(value, XmlRpcValue::TypeInt);
    const int number = value;
    requireRange(number, field.low, field.high);
    *field.value = number;
  }
  void operator()(const CountField& field) const {
    int number = 0;
    (*this)(IntegerField{&number, field.low, field.high});
    *field.value = static_cast<std::size_t>(number);
  }
  void operator()(const FlagField& field) const {
    requireType(value, XmlRpcValue::TypeBoolean);
    *field.value = static_cast<bool&>(value);
  }
  void operator()(const TextField& field) const { *field.value = text(field.may_be_empty); }
  void operator()(const ChoiceField& field) const {
    const std::string word = text();
    const auto found = std::find(field.words.begin(), field.words.end(), word);
    if (found == field.words.end()) {
      throw std::invalid_argument("is '" + printable(word) +
                                  "', allowed are: " + agrid::joined(field.words));
    }
    field.choose(static_cast<std::size_t>(found - field.words.begin()));
  }
  void operator()(const PolygonField& field) const {
    requireType(value, XmlRpcValue::TypeArray);
    agrid::Polygon polygon;
    for (int i = 0; i < value.size() && i < kMostPoints; ++i) {
      XmlRpcValue& point = value[i];
      if (point.getType() != XmlRpcValue::TypeArray || point.size() != 2) {
        throw std::invalid_argument("must be a list of points [x, y]");
      }
      polygon.emplace_back(number(point[0]), number(point[1]));
    }
    *field.value = polygon;
  }

 private:
  // a parameter file that says 5 sends an integer
  static double number(XmlRpcValue& value) {
    if (value.getType() == XmlRpcValue::TypeInt) return static_cast<int&>(value);
    requireType(value, XmlRpcValue::TypeDouble);
    return static_cast<double&>(value);
  }
  // the comparison is false for NaN, too
  static void requireRange(double number, double low, double high) {
    if (number >= low && number <= high) return;
    throw std::invalid_argument("is " + formatNumber(number) + ", allowed [" + formatNumber(low) +
                                ", " + formatNumber(high) + "]");
  }
  std::string text(bool may_be_empty = false) const {
    requireType(value, XmlRpcValue::TypeString);
    const std::string& result = value;
    if (result.empty() && may_be_empty) return result;
    if (result.empty() || result.size() > kLongestText || !isPrintable(result)) {
      throw std::invalid_argument("has " + std::to_string(result.size()) +
                                  " bytes, allowed are 1 to " + std::to_string(kLongestText) +
                                  " of UTF-8 without control characters");
    }
    return result;
  }
};

/// What is wrong with values that are fine one by one.
std::vector<std::string> contradictions(const Parameters& p) {
  std::vector<std::string> errors;
  const auto require = [&errors](bool fine, const std::string& error) {
    if (!fine) errors.push_back(error);
  };
  const agrid::WallParams& walls = p.pipeline.walls;
  require(p.map.free_max < p.map.occupied_min, "free_max must be less than occupied_min");
  require(walls.canny_low <= walls.canny_high, "canny_low must not exceed canny_high");
  require(walls.min_threshold_votes < walls.max_threshold_votes,
          "min_threshold must be less than max_threshold");
  const agrid::PassageParams& passages = p.pipeline.areas.passages;
  require(passages.min_width <= passages.max_width,
          "passage_min_width must not exceed passage_max_width");
  const std::string planner = agrid::problemOf(p.planner);
  require(planner.empty(), planner);
  return errors;
}

/// Names in the namespace that are no parameter of ours.
std::vector<std::string> unknownNames(XmlRpcValue& values) {
  // read by nodelet::Loader where the nodelet runs as a node of its own
  static const std::set<std::string> kForeign = {"num_worker_threads"};
  const std::vector<std::string> names = parameterNames();
  std::vector<std::string> warnings;
  for (auto& [name, value] : values) {
    if (kForeign.count(name) || std::binary_search(names.begin(), names.end(), name)) continue;
    const std::string shown = printable(name.substr(0, kLongestText));
    warnings.push_back("there is no parameter '" + shown + "'; the nearest known one is '" +
                       agrid::closestNames(shown, names, 1).at(0) + "'");
  }
  return warnings;
}

}  // namespace

ParameterReading readParameters(const XmlRpcValue& values) {
  ParameterReading reading;
  XmlRpcValue copy = values;  // XmlRpcValue can only be read where it can be changed
  if (copy.getType() != XmlRpcValue::TypeStruct) return reading;
  for (const ParameterEntry& entry : parameterTable(reading.parameters)) {
    if (!copy.hasMember(entry.name)) continue;
    try {
      std::visit(Store{copy[entry.name]}, entry.field);
    } catch (const std::invalid_argument& error) {
      reading.errors.push_back("~" + entry.name + " " + error.what());
    }
  }
  for (const std::string& error : contradictions(reading.parameters)) {
    reading.errors.push_back(error);
  }
  reading.warnings = unknownNames(copy);
  return reading;
}

std::vector<std::string> parameterNames() {
  Parameters parameters;
  std::vector<std::string> names;
  for (const ParameterEntry& entry : parameterTable(parameters)) names.push_back(entry.name);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace agrid_map_ros

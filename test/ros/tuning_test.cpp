// SPDX-License-Identifier: BSD-3-Clause
// What dynamic_reconfigure shows of the parameters is what the node accepts.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include <agrid_map/AGridConfig.h>

#include "ros/parameter_table.h"

namespace agrid_map_ros {
namespace {

using agrid_map::AGridConfig;
using Message = dynamic_reconfigure::Config;

Message messageOf(const AGridConfig& config) {
  Message message;
  config.__toMessage__(message);
  return message;
}

template <typename T>
auto namedIn(const std::vector<T>& entries, const std::string& name) {
  return std::find_if(entries.begin(), entries.end(),
                      [&name](const T& entry) { return entry.name == name; });
}

/// Compares one parameter of ours with what is shown of it; what is not shown has nobody to differ.
struct Comparison {
  const std::string& name;
  const Message low = messageOf(AGridConfig::__getMin__());
  const Message high = messageOf(AGridConfig::__getMax__());
  const Message preset = messageOf(AGridConfig::__getDefault__());

  bool operator()(const NumberField& field) const {
    return numbers(&Message::doubles, field.low, field.high, *field.value);
  }
  bool operator()(const IntegerField& field) const {
    return numbers(&Message::ints, field.low, field.high, *field.value);
  }
  bool operator()(const CountField& field) const {
    return numbers(&Message::ints, field.low, field.high, static_cast<int>(*field.value));
  }
  bool operator()(const FlagField& field) const {
    const auto shown = namedIn(preset.bools, name);
    if (shown == preset.bools.end()) return false;
    EXPECT_EQ(shown->value != 0, *field.value) << name;
    return true;
  }
  bool operator()(const TextField& field) const {
    const auto shown = namedIn(preset.strs, name);
    if (shown == preset.strs.end()) return false;
    EXPECT_EQ(shown->value, *field.value) << name;
    return true;
  }
  bool operator()(const ChoiceField& field) const {
    const auto shown = namedIn(preset.strs, name);
    if (shown == preset.strs.end()) return false;
    EXPECT_EQ(std::count(field.words.begin(), field.words.end(), shown->value), 1) << name;
    return true;
  }
  bool operator()(const PolygonField&) const { return false; }

 private:
  template <typename T>
  bool numbers(std::vector<T> Message::*entries, double least, double most, double value) const {
    const auto shown = namedIn(preset.*entries, name);
    if (shown == (preset.*entries).end()) return false;
    EXPECT_EQ(shown->value, value) << name;
    EXPECT_EQ(namedIn(low.*entries, name)->value, least) << name;
    EXPECT_EQ(namedIn(high.*entries, name)->value, most) << name;
    return true;
  }
};

TEST(Tuning, ShowsTheTypesRangesAndDefaultsOfTheNode) {
  Parameters defaults;
  std::size_t shown = 0;
  for (const ParameterEntry& entry : parameterTable(defaults)) {
    if (std::visit(Comparison{entry.name}, entry.field)) ++shown;
  }
  const Message all = messageOf(AGridConfig::__getDefault__());
  EXPECT_EQ(shown, all.bools.size() + all.ints.size() + all.doubles.size() + all.strs.size());
}

TEST(Tuning, TheDefaultsAreGoodTogether) {
  const Message message = messageOf(AGridConfig::__getDefault__());
  XmlRpc::XmlRpcValue values;
  for (const auto& word : message.strs) values[word.name] = word.value;
  for (const auto& number : message.doubles) values[number.name] = number.value;
  const ParameterReading reading = readParameters(values);
  EXPECT_TRUE(reading.errors.empty()) << reading.errors.front();
  EXPECT_EQ(reading.parameters.pipeline.areas.method, agrid::AreaParams{}.method);
  EXPECT_EQ(reading.parameters.planner.clearance, agrid::PlannerParams{}.clearance);
  EXPECT_EQ(reading.parameters.planner.motion, agrid::PlannerParams{}.motion);
}

}  // namespace
}  // namespace agrid_map_ros

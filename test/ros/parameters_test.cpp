// SPDX-License-Identifier: BSD-3-Clause
#include "agrid_map_ros/parameters.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "ros/parameter_table.h"

namespace agrid_map_ros {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue with(const std::string& name, const XmlRpcValue& value) {
  XmlRpcValue values;
  values[name] = value;
  return values;
}

std::string onlyError(const ParameterReading& reading) {
  return reading.errors.size() == 1 ? reading.errors.front()
                                    : std::to_string(reading.errors.size()) + " errors";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Parameters, NothingGivenMeansDefaults) {
  const ParameterReading reading = readParameters(XmlRpcValue());
  EXPECT_TRUE(reading.errors.empty());
  EXPECT_TRUE(reading.warnings.empty());
  EXPECT_EQ(reading.parameters.planner.robot_radius, agrid::PlannerParams{}.robot_radius);
}

TEST(Parameters, ValuesReachTheirStructs) {
  XmlRpcValue values;
  values["canny_high"] = 50.5;
  values["max_threshold"] = 150;
  values["estimate_direction"] = false;
  values["base_frame"] = std::string("robot");
  values["clearance"] = std::string("strict");
  values["area_method"] = std::string("paper");
  const ParameterReading reading = readParameters(values);
  ASSERT_TRUE(reading.errors.empty()) << reading.errors.front();
  EXPECT_EQ(reading.parameters.pipeline.walls.canny_high, 50.5);
  EXPECT_EQ(reading.parameters.pipeline.walls.max_threshold_votes, 150);
  EXPECT_FALSE(reading.parameters.pipeline.walls.estimate_direction);
  EXPECT_EQ(reading.parameters.node.base_frame, "robot");
  EXPECT_EQ(reading.parameters.planner.clearance, agrid::Clearance::kStrict);
  EXPECT_EQ(reading.parameters.pipeline.areas.method, agrid::AreaMethod::kPaper);
}

TEST(Parameters, R1_IntegerIsFineForNumber) {
  const ParameterReading reading = readParameters(with("timeout", 7));
  EXPECT_TRUE(reading.errors.empty());
  EXPECT_EQ(reading.parameters.planner.timeout, 7.0);
}

TEST(Parameters, R1_WrongTypeIsAnError) {
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, XmlRpcValue>>{{"robot_radius", std::string("0.3")},
                                                        {"robot_radius", true},
                                                        {"max_threshold", 20.0},
                                                        {"max_threshold", std::string("20")},
                                                        {"strict_values", 1},
                                                        {"planner", 3},
                                                        {"clearance", false}}) {
    const ParameterReading reading = readParameters(with(name, value));
    EXPECT_TRUE(contains(onlyError(reading), "~" + name + " is ")) << onlyError(reading);
    EXPECT_TRUE(contains(onlyError(reading), "must be ")) << onlyError(reading);
    EXPECT_EQ(reading.parameters.planner.robot_radius, agrid::PlannerParams{}.robot_radius);
  }
}

TEST(Parameters, R2_OutOfRangeIsAnErrorThatNamesTheRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity, -0.1, 1e9}) {
    const std::string error = onlyError(readParameters(with("robot_radius", bad)));
    EXPECT_TRUE(contains(error, "allowed [0, 1000]")) << error;
  }
  EXPECT_TRUE(contains(onlyError(readParameters(with("timeout", 0))), "allowed [0.001, 60]"));
  EXPECT_TRUE(contains(onlyError(readParameters(with("max_threshold", 0))), "allowed [1, "));
  EXPECT_TRUE(contains(onlyError(readParameters(with("clearance", std::string("Strict")))),
                       "costmap, strict"));
}

XmlRpcValue polygon(const std::vector<std::pair<double, double>>& points) {
  XmlRpcValue list;
  list.setSize(0);
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    list[i][0] = points[static_cast<std::size_t>(i)].first;
    list[i][1] = points[static_cast<std::size_t>(i)].second;
  }
  return list;
}

TEST(Parameters, FootprintIsAListOfPoints) {
  XmlRpcValue list = polygon({{0.5, 0.25}, {-0.5, 0.25}, {0, -0.25}});
  list[2][0] = 0;  // an integer
  const ParameterReading reading = readParameters(with("footprint", list));
  ASSERT_TRUE(reading.errors.empty()) << reading.errors.front();
  ASSERT_EQ(reading.parameters.planner.footprint.size(), 3U);
  EXPECT_EQ(reading.parameters.planner.footprint[2], agrid::Point2(0, -0.25));
  EXPECT_TRUE(readParameters(with("footprint", polygon({}))).errors.empty());
}

TEST(Parameters, R2_R4_BadFootprintIsOneError) {
  XmlRpcValue flat;
  flat[0] = 0.5;
  XmlRpcValue text = polygon({{1, 1}, {-1, 1}, {0, -1}});
  text[1][1] = std::string("1");
  XmlRpcValue three = polygon({{1, 1}, {-1, 1}, {0, -1}});
  three[1][2] = 0.0;
  for (const XmlRpcValue& bad :
       {flat, text, three, XmlRpcValue(0.5), polygon({{1, 1}, {-1, 1}}),
        polygon({{1, 1}, {std::nan(""), 1}, {0, -1}}),
        polygon({{1, 1}, {-1, -1}, {1, -1}, {-1, 1}}), polygon({{1, 1}, {2, 1}, {2, 2}}),
        polygon(std::vector<std::pair<double, double>>(5000))}) {
    const ParameterReading reading = readParameters(with("footprint", bad));
    EXPECT_TRUE(contains(onlyError(reading), "footprint")) << onlyError(reading);
  }
}

TEST(Parameters, R2_InvertedPairs) {
  EXPECT_TRUE(contains(onlyError(readParameters(with("canny_low", 31))), "canny_low"));
  EXPECT_TRUE(contains(onlyError(readParameters(with("min_threshold", 350))), "min_threshold"));
  EXPECT_TRUE(contains(onlyError(readParameters(with("free_max", 65))), "free_max"));
  EXPECT_TRUE(contains(onlyError(readParameters(with("passage_min_width", 1.4))), "passage_"));
}

TEST(Parameters, R3_UnknownNameWarnsWithTheNearestKnownOne) {
  const ParameterReading reading = readParameters(with("robot_raduis", 0.3));
  EXPECT_TRUE(reading.errors.empty());
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_TRUE(contains(reading.warnings.front(), "'robot_raduis'"));
  EXPECT_TRUE(contains(reading.warnings.front(), "'robot_radius'"));
}

TEST(Parameters, R3_NodeletLoadersOwnParameterIsKnown) {
  EXPECT_TRUE(readParameters(with("num_worker_threads", 4)).warnings.empty());
}

TEST(Parameters, R4_HugeOrNestedValues) {
  XmlRpcValue list;
  list[0] = 1;
  for (const XmlRpcValue& bad :
       {XmlRpcValue(std::string(1 << 20, 'x')), list, with("x", 1), XmlRpcValue(std::string()),
        XmlRpcValue(std::string("a\nb")), XmlRpcValue(std::string("\xff"))}) {
    const ParameterReading reading = readParameters(with("base_frame", bad));
    EXPECT_EQ(reading.errors.size(), 1U);
    EXPECT_LT(onlyError(reading).size(), 200U);
    EXPECT_EQ(reading.parameters.node.base_frame, "base_link");
  }
  EXPECT_TRUE(readParameters(XmlRpcValue(3)).errors.empty());
}

// --- what is written about them ------------------------------------------------------------------

std::string fileText(const std::string& path) {
  std::ifstream file(std::string(AGRID_SOURCE) + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// name -> default, from the rows "| `name` | default | ..." of doc/parameters.md.
std::map<std::string, std::string> documented() {
  const std::string text = fileText("/doc/parameters.md");
  const std::regex row("\\| `([a-z0-9_]+)` \\| ([^|]+) \\|");
  std::map<std::string, std::string> rows;
  for (std::sregex_iterator it(text.begin(), text.end(), row), end; it != end; ++it) {
    rows[(*it)[1]] = (*it)[2];
  }
  return rows;
}

struct ExpectDefault {
  YAML::Node node;
  void operator()(const NumberField& f) const { EXPECT_EQ(node.as<double>(), *f.value); }
  void operator()(const IntegerField& f) const { EXPECT_EQ(node.as<int>(), *f.value); }
  void operator()(const CountField& f) const { EXPECT_EQ(node.as<std::size_t>(), *f.value); }
  void operator()(const FlagField& f) const { EXPECT_EQ(node.as<bool>(), *f.value); }
  void operator()(const TextField& f) const { EXPECT_EQ(node.as<std::string>(), *f.value); }
  void operator()(const PolygonField& f) const { EXPECT_EQ(node.size(), f.value->size()); }
  void operator()(const ChoiceField& f) const {
    EXPECT_NE(std::find(f.words.begin(), f.words.end(), node.as<std::string>()), f.words.end());
  }
};

TEST(Parameters, CodeConfigAndDocumentNameTheSameSetWithTheSameDefaults) {
  const YAML::Node config = YAML::LoadFile(std::string(AGRID_SOURCE) + "/config/agrid.yaml");
  std::map<std::string, std::string> in_document = documented();
  Parameters parameters;
  for (const ParameterEntry& entry : parameterTable(parameters)) {
    SCOPED_TRACE(entry.name);
    ASSERT_TRUE(config[entry.name]);
    std::visit(ExpectDefault{config[entry.name]}, entry.field);
    EXPECT_EQ(YAML::Dump(YAML::Load(in_document[entry.name])), YAML::Dump(config[entry.name]));
  }
  EXPECT_EQ(config.size(), parameterNames().size());
  EXPECT_EQ(in_document.size(), parameterNames().size());
}

}  // namespace
}  // namespace agrid_map_ros

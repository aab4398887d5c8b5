// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameter_table.h"

namespace agrid_map_ros {
namespace {

using Table = std::vector<ParameterEntry>;

void addMap(Table& table, agrid::MapParams& p) {
  table.push_back({"free_max", IntegerField{&p.free_max, 0, 99}});
  table.push_back({"occupied_min", IntegerField{&p.occupied_min, 1, 100}});
  table.push_back({"max_pixels", NumberField{&p.max_pixels, 1, 4e9}});
  table.push_back({"strict_values", FlagField{&p.strict_values}});
}

void addWalls(Table& table, agrid::WallParams& p) {
  table.push_back({"canny_low", NumberField{&p.canny_low, 0, 1e4}});
  table.push_back({"canny_high", NumberField{&p.canny_high, 0, 1e4}});
  table.push_back({"max_threshold", IntegerField{&p.max_threshold_votes, 1, 1000000}});
  table.push_back({"min_threshold", IntegerField{&p.min_threshold_votes, 1, 1000000}});
  table.push_back({"threshold_step", IntegerField{&p.threshold_step_votes, 1, 1000000}});
  table.push_back({"min_line_distance", NumberField{&p.min_line_distance_px, 1, 1000}});
  table.push_back({"distance_resolution", NumberField{&p.distance_resolution_px, 0.5, 100}});
  table.push_back({"estimate_direction", FlagField{&p.estimate_direction}});
  table.push_back({"direction", NumberField{&p.direction_deg, -360, 360}});
}

void addAreas(Table& table, agrid::AreaParams& p) {
  table.push_back(
      {"area_method",
       ChoiceField{{agrid::kAreaMethodNames.begin(), agrid::kAreaMethodNames.end()},
                   [&p](std::size_t i) { p.method = static_cast<agrid::AreaMethod>(i); }}});
  table.push_back({"max_clutter_diagonal", NumberField{&p.max_clutter_diagonal, 0, 100}});
  table.push_back({"min_island_size", NumberField{&p.min_island_size, 0, 1e6}});
  table.push_back({"min_separation", NumberField{&p.min_separation, 0, 1}});
  table.push_back({"merge_ratio", NumberField{&p.merge_ratio, 1e-3, 1}});
  table.push_back({"min_prominence", NumberField{&p.min_prominence, 0, 100}});
  table.push_back({"min_area_size", NumberField{&p.min_area_size, 0, 1e6}});
  table.push_back({"min_area_clearance", NumberField{&p.min_area_clearance, 0, 100}});
  table.push_back({"max_door_width", NumberField{&p.max_door_width, 0, 1e3}});
  table.push_back({"min_border_length", NumberField{&p.min_border_length, 0, 1e3}});
}

void addPassages(Table& table, agrid::PassageParams& p) {
  table.push_back({"passage_min_width", NumberField{&p.min_width, 0, 100}});
  table.push_back({"passage_max_width", NumberField{&p.max_width, 0, 100}});
  table.push_back({"passage_max_skew", NumberField{&p.max_skew_deg, 0, 45}});
  table.push_back({"passage_min_spacing", NumberField{&p.min_spacing, 0, 100}});
  table.push_back({"passage_support_reach", NumberField{&p.support_reach, 0, 10}});
  table.push_back({"passage_min_support", NumberField{&p.min_support, 0, 10}});
  table.push_back({"passage_opening", NumberField{&p.opening, 0, 10}});
}

void addPlanner(Table& table, agrid::PlannerParams& p) {
  table.push_back({"robot_radius", NumberField{&p.robot_radius, 0, 1000}});
  table.push_back({"clearance", ChoiceField{{"costmap", "strict"}, [&p](std::size_t i) {
                                              p.clearance = i == 0 ? agrid::Clearance::kCostmap
                                                                   : agrid::Clearance::kStrict;
                                            }}});
  table.push_back({"allow_unknown", FlagField{&p.allow_unknown}});
  table.push_back({"timeout", NumberField{&p.timeout, 1e-3, 60}});
  table.push_back({"planner", ChoiceField{agrid::plannerNames(), [&p](std::size_t i) {
                                            p.planner = agrid::plannerNames()[i];
                                          }}});
  table.push_back({"turning_radius", NumberField{&p.turning_radius, 0, 1000}});
  table.push_back({"footprint", PolygonField{&p.footprint}});
  table.push_back({"motion", ChoiceField{{"reeds_shepp", "dubins"}, [&p](std::size_t i) {
                                           p.motion = i == 0 ? agrid::Motion::kReedsShepp
                                                             : agrid::Motion::kDubins;
                                         }}});
}

void addNode(Table& table, NodeParams& p) {
  table.push_back({"base_frame", TextField{&p.base_frame}});
  table.push_back({"tf_timeout", NumberField{&p.tf_timeout, 0, 0.5}});
  table.push_back({"area_period", NumberField{&p.area_period, 0.05, 60}});
  table.push_back({"static_map_wait", NumberField{&p.static_map_wait, 0, 3600}});
  table.push_back({"max_parallel_plans", IntegerField{&p.max_parallel_plans, 0, 64}});
  table.push_back({"max_queued_plans", IntegerField{&p.max_queued_plans, 0, 10000}});
  table.push_back({"strict_params", FlagField{&p.strict_params}});
}

void addEdits(Table& table, agrid::EditParams& p) {
  table.push_back({"door_snap_dist", NumberField{&p.door_snap_dist, 0.01, 5}});
  table.push_back({"tags_in_unknown", FlagField{&p.allow_unknown}});
  table.push_back({"max_tags", CountField{&p.max_tags, 1, 1000000}});
}

void addDialogue(Table& table, Parameters& parameters) {
  agrid::dialogue::DialogueParams& p = parameters.dialogue;
  table.push_back({"click_tag", TextField{&parameters.hearing.click_tag, true}});
  table.push_back({"grammar_file", TextField{&parameters.hearing.grammar_file, true}});
  table.push_back({"object_distance", NumberField{&p.object_distance, 0.01, 100}});
  table.push_back({"door_reach", NumberField{&p.door_reach, 0.01, 100}});
  table.push_back({"most_named", CountField{&p.most_named, 1, 1000}});
  table.push_back({"near", NumberField{&p.relations.near, 0, 100}});
  table.push_back({"next_to", NumberField{&p.relations.next_to, 0, 100}});
  table.push_back({"side_range", NumberField{&p.relations.side_range, 0, 1000}});
  table.push_back({"sector_half_angle", NumberField{&p.relations.sector_half_angle_deg, 1, 90}});
  table.push_back({"north_yaw", NumberField{&p.relations.north_yaw_deg, -360, 360}});
}

void addStorage(Table& table, StorageParams& p) {
  table.push_back({"storage_dir", TextField{&p.directory, true}});
  table.push_back({"storage_name", TextField{&p.name, true}});
  table.push_back({"persistent", FlagField{&p.persistent}});
  table.push_back({"read_only", FlagField{&p.read_only}});
}

}  // namespace

std::vector<ParameterEntry> parameterTable(Parameters& parameters) {
  Table table;
  addMap(table, parameters.map);
  addWalls(table, parameters.pipeline.walls);
  table.push_back({"max_cells", NumberField{&parameters.pipeline.grid.max_cells, 1, 1e8}});
  addAreas(table, parameters.pipeline.areas);
  addPassages(table, parameters.pipeline.areas.passages);
  addPlanner(table, parameters.planner);
  addEdits(table, parameters.edits);
  addDialogue(table, parameters);
  addStorage(table, parameters.storage);
  addNode(table, parameters.node);
  return table;
}

}  // namespace agrid_map_ros

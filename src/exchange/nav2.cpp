// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "exchange/json_text.h"
#include "exchange/plain_text.h"
#include "exchange/route_graph.h"
#include "exchange/writers.h"

namespace agrid {
namespace {

Json metadataOf(const RouteNode& node, const AreaMap& areas) {
  if (node.area) {
    const Area& area = areas.areas[*node.area];
    return {{"kind", "area"},
            {"area", static_cast<std::uint32_t>(area.id)},
            {"name", area.name},
            {"category", area.category.empty() ? area.category_guess : area.category}};
  }
  if (node.door) {
    const Door& door = areas.doors[*node.door];
    return {{"kind", wordOf(door.kind)},
            {"door", static_cast<std::uint32_t>(door.id)},
            {"name", door.name},
            {"width", rounded(door.width)}};
  }
  return {{"kind", "corner"}};
}

Json nodeFeature(std::size_t id, const RouteNode& node, const AreaMap& areas,
                 const std::string& frame_id) {
  return {{"type", "Feature"},
          {"properties", {{"id", id}, {"frame", frame_id}, {"metadata", metadataOf(node, areas)}}},
          {"geometry", {{"type", "Point"}, {"coordinates", jsonPoint(node.point_map)}}}};
}

/// An edge; the doors it begins and ends in are told, so that they can be closed by its id.
Json edgeFeature(std::size_t id, const RouteLink& link, const RouteGraph& graph,
                 const AreaMap& areas) {
  const RouteNode& from = graph.nodes[link.a];
  const RouteNode& to = graph.nodes[link.b];
  const double length = (to.point_map - from.point_map).norm();
  Json doors = Json::array();
  for (const RouteNode* node : {&from, &to}) {
    if (node->door) doors.push_back(static_cast<std::uint32_t>(areas.doors[*node->door].id));
  }
  Json line = Json::array({jsonPoint(from.point_map), jsonPoint(to.point_map)});
  return {
      {"type", "Feature"},
      {"properties",
       {{"id", id},
        {"startid", link.a + 1},
        {"endid", link.b + 1},
        {"cost", rounded(length)},
        {"overridable", true},
        {"metadata", {{"doors", std::move(doors)}}}}},
      {"geometry", {{"type", "MultiLineString"}, {"coordinates", Json::array({std::move(line)})}}}};
}

}  // namespace

Exported routeGraphText(const SemanticMap& map, const ExportParams& params) {
  if (!params.find_way) throw std::invalid_argument("find_way: a route graph needs one");
  RouteGraph graph = findRouteGraph(map, params.find_way);
  Json features = Json::array();
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    features.push_back(nodeFeature(i + 1, graph.nodes[i], map.area_map, params.frame_id));
  }
  std::size_t id = graph.nodes.size();  // nodes and edges share their ids
  for (const RouteLink& link : graph.links) {
    features.push_back(edgeFeature(++id, link, graph, map.area_map));
    features.push_back(edgeFeature(++id, {link.b, link.a}, graph, map.area_map));
  }
  if (graph.links.empty()) {
    graph.warnings.emplace_back(
        "there is no way from one place to another: the route server "
        "refuses a graph without edges");
  }
  return {"{\"type\": \"FeatureCollection\",\n \"name\": \"agrid_map\",\n \"crs\": " +
              jsonText(jsonFrame(params.frame_id)) + ",\n \"frame_id\": " +
              jsonText(params.frame_id) + ",\n \"features\": " + jsonLines(features) + "}\n",
          std::move(graph.warnings)};
}

}  // namespace agrid

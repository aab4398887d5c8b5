// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <tinyxml2.h>

#include "agrid/semantic_map/object_area.h"
#include "exchange/plain_text.h"
#include "exchange/writers.h"

namespace agrid {
namespace {

/// What is said of a node or an edge, in order.
struct Datum {
  std::string name;
  std::string type;  ///< of GraphML: string, double, int
  std::string value;
};
using Data = std::vector<Datum>;

struct Node {
  std::string id;
  Data data;
};

struct Edge {
  std::string id;
  std::string source;
  std::string target;
  Data data;
};

Datum text(const char* name, const std::string& value) {
  return {name, "string", plainText(value)};
}
Datum number(const char* name, double value) { return {name, "double", plainNumber(value)}; }
Datum whole(const char* name, std::uint32_t value) { return {name, "int", std::to_string(value)}; }

template <typename Id>
std::uint32_t numberOf(Id id) {
  return static_cast<std::uint32_t>(id);
}

std::string nodeId(AreaId id) {
  return id == AreaId{0} ? "outside" : "area_" + std::to_string(numberOf(id));
}

void addProperties(const Properties& properties, Data& data) {
  for (const auto& [key, value] : properties) {
    data.push_back({"property:" + plainText(key), "string", plainText(value)});
  }
}

Node nodeOf(const Area& area) {
  Node node{nodeId(area.id),
            {text("kind", "area"), whole("agrid_id", numberOf(area.id)), text("name", area.name),
             text("category", area.category), text("category_guess", area.category_guess),
             number("x", area.anchor_map.x()), number("y", area.anchor_map.y()),
             number("clearance", area.anchor_clearance), number("size", area.size)}};
  addProperties(area.properties, node.data);
  return node;
}

Node nodeOf(const ObjectTag& object) {
  Node node{"object_" + std::to_string(numberOf(object.id)),
            {text("kind", "object"), whole("agrid_id", numberOf(object.id)),
             text("name", object.name), text("category", object.category),
             number("x", object.pose_map.position.x()), number("y", object.pose_map.position.y()),
             number("yaw", object.pose_map.yaw), number("length", object.size.x()),
             number("width", object.size.y()), number("height", object.height)}};
  addProperties(object.properties, node.data);
  return node;
}

Edge edgeOf(const Door& door) {
  const Point2 middle = door.jambs_map.midpoint();
  Edge edge{"door_" + std::to_string(numberOf(door.id)),
            nodeId(door.areas[0]),
            nodeId(door.areas[1]),
            {text("kind", wordOf(door.kind)), whole("agrid_id", numberOf(door.id)),
             text("name", door.name), number("x", middle.x()), number("y", middle.y()),
             number("width", door.width), text("state", wordOf(door.state)),
             number("confidence", door.confidence)}};
  addProperties(door.properties, edge.data);
  return edge;
}

struct Graph {
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

Graph graphOf(const SemanticMap& map) {
  Graph graph;
  bool has_outside = false;
  for (const Area& area : map.area_map.areas) graph.nodes.push_back(nodeOf(area));
  for (const Door& door : map.area_map.doors) {
    graph.edges.push_back(edgeOf(door));
    has_outside = has_outside || door.areas[0] == AreaId{0} || door.areas[1] == AreaId{0};
  }
  if (has_outside) graph.nodes.push_back({nodeId(AreaId{0}), {text("kind", "outside")}});
  for (const ObjectTag& object : map.knowledge.objects) {
    graph.nodes.push_back(nodeOf(object));
    const Area* area = areaOf(map, object);
    if (area == nullptr) continue;
    graph.edges.push_back({"in_" + std::to_string(numberOf(object.id)),
                           graph.nodes.back().id,
                           nodeId(area->id),
                           {text("kind", "in")}});
  }
  return graph;
}

/// Numbers of the keys, which GraphML declares before they are used.
using Keys = std::map<std::string, std::string>;

template <typename Item>
Keys declareKeys(const std::vector<Item>& items, const char* what, tinyxml2::XMLPrinter& xml) {
  Keys keys;
  for (const Item& item : items) {
    for (const Datum& datum : item.data) {
      const std::string id = std::string(what) + std::to_string(keys.size());
      if (!keys.emplace(datum.name, id).second) continue;
      xml.OpenElement("key");
      xml.PushAttribute("id", id.c_str());
      xml.PushAttribute("for", what);
      xml.PushAttribute("attr.name", datum.name.c_str());
      xml.PushAttribute("attr.type", datum.type.c_str());
      xml.CloseElement();
    }
  }
  return keys;
}

void writeData(const Data& data, const Keys& keys, tinyxml2::XMLPrinter& xml) {
  for (const Datum& datum : data) {
    xml.OpenElement("data");
    xml.PushAttribute("key", keys.at(datum.name).c_str());
    xml.PushText(datum.value.c_str());
    xml.CloseElement();
  }
}

void writeGraph(const Graph& graph, const std::pair<Keys, Keys>& keys, tinyxml2::XMLPrinter& xml) {
  for (const Node& node : graph.nodes) {
    xml.OpenElement("node");
    xml.PushAttribute("id", node.id.c_str());
    writeData(node.data, keys.first, xml);
    xml.CloseElement();
  }
  for (const Edge& edge : graph.edges) {
    xml.OpenElement("edge");
    xml.PushAttribute("id", edge.id.c_str());
    xml.PushAttribute("source", edge.source.c_str());
    xml.PushAttribute("target", edge.target.c_str());
    writeData(edge.data, keys.second, xml);
    xml.CloseElement();
  }
}

void writeGraphAttribute(const char* name, const std::string& value, tinyxml2::XMLPrinter& xml) {
  xml.OpenElement("data");
  xml.PushAttribute("key", name);
  xml.PushText(plainText(value).c_str());
  xml.CloseElement();
}

}  // namespace

std::string graphmlText(const SemanticMap& map, const std::string& frame_id) {
  const Graph graph = graphOf(map);
  tinyxml2::XMLPrinter xml;
  xml.PushHeader(false, true);
  xml.OpenElement("graphml");
  xml.PushAttribute("xmlns", "http://graphml.graphdrawing.org/xmlns");
  const Keys node_keys = declareKeys(graph.nodes, "node", xml);
  const Keys edge_keys = declareKeys(graph.edges, "edge", xml);
  for (const char* name : {"frame_id", "map_id"}) {
    xml.OpenElement("key");
    xml.PushAttribute("id", name);
    xml.PushAttribute("for", "graph");
    xml.PushAttribute("attr.name", name);
    xml.PushAttribute("attr.type", "string");
    xml.CloseElement();
  }
  xml.OpenElement("graph");
  xml.PushAttribute("id", "agrid_map");
  xml.PushAttribute("edgedefault", "undirected");
  writeGraphAttribute("frame_id", frame_id, xml);
  writeGraphAttribute("map_id", map.map().digest(), xml);
  writeGraph(graph, {node_keys, edge_keys}, xml);
  xml.CloseElement();
  xml.CloseElement();
  return xml.CStr();
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/semantic_map/object_area.h"
#include "exchange/plain_text.h"
#include "exchange/writers.h"

namespace agrid {
namespace {

/// A double-quoted string of the DOT language that is shown as the text: in labels a backslash
/// begins an escape and an ampersand an HTML entity.
std::string dotLabel(const std::string& text) {
  std::string label = "\"";
  for (const char c : plainText(text)) {
    if (c == '"' || c == '\\') label += '\\';
    label += c;
    if (c == '&') label += "amp;";
  }
  return label + "\"";
}

/// Where `neato -n` puts a node [points]; metres times 36 leave room for names.
std::string position(const Point2& point_map) {
  return "pos=\"" + plainNumber(36 * point_map.x()) + "," + plainNumber(36 * point_map.y()) + "\"";
}

std::string nodeId(AreaId id) {
  return id == AreaId{0} ? "outside" : "area_" + std::to_string(static_cast<std::uint32_t>(id));
}

std::string line(const Area& area) {
  return "  " + nodeId(area.id) + " [label=" + dotLabel(area.name) + ", " +
         position(area.anchor_map) + "];\n";
}

std::string line(const Door& door) {
  std::string style = door.kind == DoorKind::kDoor ? "" : ", style=dashed";
  if (door.state == DoorState::kClosed) style += ", color=red";
  return "  " + nodeId(door.areas[0]) + " -- " + nodeId(door.areas[1]) +
         " [label=" + dotLabel(door.name) + ", id=\"door_" +
         std::to_string(static_cast<std::uint32_t>(door.id)) + "\"" + style + "];\n";
}

std::string lines(const SemanticMap& map, const ObjectTag& object) {
  const std::string id = "object_" + std::to_string(static_cast<std::uint32_t>(object.id));
  const Area* area = areaOf(map, object);
  const std::string node = "  " + id + " [label=" + dotLabel(object.name) + ", shape=box, " +
                           position(object.pose_map.position) + "];\n";
  if (area == nullptr) return node;
  return node + "  " + id + " -- " + nodeId(area->id) + " [style=dotted];\n";
}

}  // namespace

std::string dotText(const SemanticMap& map) {
  std::string text = "graph agrid_map {\n  charset=\"UTF-8\";\n  overlap=false;\n";
  for (const Area& area : map.area_map.areas) text += line(area);
  for (const Door& door : map.area_map.doors) text += line(door);
  for (const ObjectTag& object : map.knowledge.objects) text += lines(map, object);
  return text + "}\n";
}

}  // namespace agrid

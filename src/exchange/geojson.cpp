// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "agrid/semantic_map/object_area.h"
#include "exchange/faces.h"
#include "exchange/json_text.h"
#include "exchange/plain_text.h"
#include "exchange/writers.h"

namespace agrid {
namespace {

/// A closed ring: the first corner again at the end, as RFC 7946 has it.
Json ringJson(const Polygon& polygon) {
  Json ring = Json::array();
  for (const Point2& corner : polygon) ring.push_back(jsonPoint(corner));
  if (!ring.empty()) ring.push_back(Json(ring.front()));
  return ring;
}

Json faceJson(const Face& face, const MapGeometry& geometry) {
  Json rings = Json::array({ringJson(mapPolygon(face.outer, geometry))});
  for (const PixelRing& hole : face.holes) rings.push_back(ringJson(mapPolygon(hole, geometry)));
  return rings;
}

Json geometryJson(const char* type, Json coordinates) {
  return {{"type", type}, {"coordinates", std::move(coordinates)}};
}

Json geometryOf(const Area& area, const std::vector<Face>& faces, const MapGeometry& geometry) {
  if (faces.empty()) return geometryJson("Point", jsonPoint(area.anchor_map));
  if (faces.size() == 1) return geometryJson("Polygon", faceJson(faces[0], geometry));
  Json parts = Json::array();
  for (const Face& face : faces) parts.push_back(faceJson(face, geometry));
  return geometryJson("MultiPolygon", std::move(parts));
}

Json geometryOf(const Door& door) {
  const Json a = jsonPoint(door.jambs_map.a);
  const Json b = jsonPoint(door.jambs_map.b);
  if (a == b) return geometryJson("Point", a);
  return geometryJson("LineString", {a, b});
}

Json geometryOf(const ObjectTag& object) {
  if (rounded(object.size.x()) <= 0 || rounded(object.size.y()) <= 0) {
    return geometryJson("Point", jsonPoint(object.pose_map.position));
  }
  const Point2 half = object.size / 2;
  Polygon box;
  for (const Point2& corner : {Point2(-half.x(), -half.y()), Point2(half.x(), -half.y()),
                               Point2(half.x(), half.y()), Point2(-half.x(), half.y())}) {
    box.push_back(object.pose_map * corner);
  }
  return geometryJson("Polygon", Json::array({ringJson(box)}));
}

Json feature(const std::string& id, Json geometry, Json properties) {
  return {{"type", "Feature"},
          {"id", id},
          {"geometry", std::move(geometry)},
          {"properties", std::move(properties)}};
}

Json areaFeature(const Area& area, const std::vector<Face>& faces, const MapGeometry& geometry) {
  const auto id = static_cast<std::uint32_t>(area.id);
  return feature("area/" + std::to_string(id), geometryOf(area, faces, geometry),
                 {{"kind", "area"},
                  {"id", id},
                  {"name", area.name},
                  {"category", area.category},
                  {"category_guess", area.category_guess},
                  {"anchor", jsonPoint(area.anchor_map)},
                  {"anchor_clearance", rounded(area.anchor_clearance)},
                  {"size", rounded(area.size)},
                  {"source", wordOf(area.source)},
                  {"properties", Json(area.properties)}});
}

Json doorFeature(const Door& door) {
  const auto id = static_cast<std::uint32_t>(door.id);
  return feature(
      "door/" + std::to_string(id), geometryOf(door),
      {{"kind", wordOf(door.kind)},
       {"id", id},
       {"name", door.name},
       {"areas",
        {static_cast<std::uint32_t>(door.areas[0]), static_cast<std::uint32_t>(door.areas[1])}},
       {"width", rounded(door.width)},
       {"state", wordOf(door.state)},
       {"confidence", rounded(door.confidence)},
       {"source", wordOf(door.source)},
       {"properties", Json(door.properties)}});
}

Json objectFeature(const SemanticMap& map, const ObjectTag& object) {
  const auto id = static_cast<std::uint32_t>(object.id);
  const Area* area = areaOf(map, object);
  return feature("object/" + std::to_string(id), geometryOf(object),
                 {{"kind", "object"},
                  {"id", id},
                  {"name", object.name},
                  {"category", object.category},
                  {"area", area == nullptr ? 0U : static_cast<std::uint32_t>(area->id)},
                  {"position", jsonPoint(object.pose_map.position)},
                  {"yaw", std::round(object.pose_map.yaw * 1e8) / 1e8},
                  {"box", jsonPoint(object.size)},
                  {"height", rounded(object.height)},
                  {"source", wordOf(object.source)},
                  {"properties", Json(object.properties)}});
}

}  // namespace

std::string geoJsonText(const SemanticMap& map, const std::string& frame_id) {
  const std::vector<std::vector<Face>> faces = areaFaces(map);
  Json features = Json::array();
  for (std::size_t k = 0; k < faces.size(); ++k) {
    features.push_back(areaFeature(map.area_map.areas[k], faces[k], map.map().geometry()));
  }
  for (const Door& door : map.area_map.doors) features.push_back(doorFeature(door));
  for (const ObjectTag& object : map.knowledge.objects) {
    features.push_back(objectFeature(map, object));
  }
  return "{\"type\": \"FeatureCollection\",\n \"crs\": " + jsonText(jsonFrame(frame_id)) +
         ",\n \"frame_id\": " + jsonText(frame_id) +
         ",\n \"units\": \"m\",\n \"map_id\": " + jsonText(map.map().digest()) +
         ",\n \"features\": " + jsonLines(features) + "}\n";
}

}  // namespace agrid

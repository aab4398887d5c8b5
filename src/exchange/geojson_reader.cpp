// SPDX-License-Identifier: BSD-3-Clause
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "agrid/map/map_io.h"
#include "agrid/tags/name.h"
#include "exchange/json_text.h"
#include "exchange/place_files.h"
#include "exchange/plain_text.h"
#include "exchange/polygon_labels.h"

namespace agrid {
namespace {

constexpr std::size_t kMostAreas = std::numeric_limits<std::uint16_t>::max();

/// One feature of a file; what is wrong with it is told by its number.
class Feature {
 public:
  Feature(const std::string& path, std::size_t number, const Json& json)
      : where_(path + ": features[" + std::to_string(number) + "]") {
    if (!json.is_object()) fail("", "is no object");
    geometry_ = member(json, "geometry");
    if (!geometry_.is_object()) fail("geometry", "is no object");
    if (json.contains("properties") && json["properties"].is_object()) about_ = json["properties"];
  }

  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    throw FileError(FileErrorCode::kIo, where_ + (key.empty() ? "" : ", " + key) + ": " + what);
  }

  std::string type() const {
    const Json type = member(geometry_, "type");
    return type.is_string() ? type.get<std::string>() : "";
  }

  /// What it is: "area", "door" or "object", by its property or its geometry.
  std::string kind() const {
    const std::string told = text("kind");
    if (told == "area" || told == "door" || told == "object") return told;
    if (told == "passage") return "door";
    const std::string shape = type();
    if (shape == "Polygon" || shape == "MultiPolygon") return "area";
    if (shape == "LineString") return "door";
    if (shape == "Point") return "object";
    fail("geometry.type",
         "'" + plainText(shape) + "', allowed are Polygon, MultiPolygon, LineString and Point");
  }

  bool has(const char* key) const { return about_.contains(key) && !about_[key].is_null(); }
  bool isAutomatic() const { return text("source") == "automatic"; }

  /// A text of its properties; empty if there is none.
  std::string text(const char* key) const {
    if (!has(key)) return {};
    if (!about_[key].is_string()) fail(std::string("properties.") + key, "is no text");
    return about_[key].get<std::string>();
  }
  std::string name(const char* key) const {
    const std::string text = this->text(key);
    const std::string problem = text.empty() ? "" : problemOfName(text);
    if (!problem.empty()) fail(std::string("properties.") + key, problem);
    return text;
  }
  double number(const char* key) const {
    return has(key) ? finite(about_[key], std::string("properties.") + key) : 0.0;
  }
  Point2 point(const char* key) const {
    return pointOf(about_[key], std::string("properties.") + key);
  }

  Properties properties() const {
    Properties properties;
    if (!has("properties")) return properties;
    if (!about_["properties"].is_object()) fail("properties.properties", "is no object");
    for (const auto& [key, value] : about_["properties"].items()) {
      if (value.is_structured() || value.is_null())
        fail("properties.properties." + key, "is no text");
      properties[key] = value.is_string() ? value.get<std::string>() : jsonText(value);
    }
    return properties;
  }

  Point2 position() const { return pointOf(member(geometry_, "coordinates"), "coordinates"); }
  Polygon line() const { return pointsOf(member(geometry_, "coordinates"), 2); }
  /// Outer boundaries and holes alike.
  std::vector<Polygon> rings() const {
    const Json coordinates = member(geometry_, "coordinates");
    std::vector<Polygon> rings;
    const Json parts = type() == "MultiPolygon" ? coordinates : Json::array({coordinates});
    if (!parts.is_array()) fail("coordinates", "is no list");
    for (const Json& part : parts) {
      if (!part.is_array()) fail("coordinates", "a polygon is a list of rings");
      for (const Json& ring : part) rings.push_back(pointsOf(ring, 4));
    }
    return rings;
  }

 private:
  Json member(const Json& json, const char* key) const {
    if (!json.contains(key)) fail(key, "is missing");
    return json[key];
  }
  double finite(const Json& json, const std::string& key) const {
    if (!json.is_number() || !std::isfinite(json.get<double>())) fail(key, "is no finite number");
    return json.get<double>();
  }
  Point2 pointOf(const Json& json, const std::string& key) const {
    if (!json.is_array() || json.size() < 2) fail(key, "a point is [x, y]");
    return {finite(json[0], key), finite(json[1], key)};
  }
  Polygon pointsOf(const Json& json, std::size_t least) const {
    if (!json.is_array() || json.size() < least) {
      fail("coordinates", "needs " + std::to_string(least) + " points or more");
    }
    Polygon points;
    for (const Json& point : json) points.push_back(pointOf(point, "coordinates"));
    return points;
  }

  std::string where_;
  Json geometry_;
  Json about_ = Json::object();
};

void readArea(const Feature& feature, const OccupancyMap& map, GivenPlace& place) {
  if (feature.type() == "Point") return;  // one of ours that no pixel shows
  if (feature.type() != "Polygon" && feature.type() != "MultiPolygon") {
    feature.fail("geometry.type", "an area is a Polygon or MultiPolygon");
  }
  if (place.areas.size() == kMostAreas) feature.fail("", "more than 65535 areas");
  // the names of automatic areas are only numbers
  const std::string name = feature.isAutomatic() ? "" : feature.name("name");
  place.areas.push_back({name, feature.name("category"), feature.properties()});
  std::vector<Polygon> rings;
  for (const Polygon& ring : feature.rings()) rings.push_back(pixelRing(ring, map.geometry()));
  paintPolygon(rings, static_cast<std::uint16_t>(place.areas.size()), map, place.labels);
}

void readDoor(const Feature& feature, GivenPlace& place) {
  if (feature.isAutomatic() || feature.type() == "Point") return;
  if (feature.type() != "LineString") feature.fail("geometry.type", "a door is a LineString");
  const Polygon line = feature.line();
  const Segment jambs{line.front(), line.back()};
  if (jambs.length() == 0) feature.fail("coordinates", "both ends of the door are one");
  DoorTag door = tagOf(PlaceDoor{feature.name("name"), jambs});
  const std::string state = feature.text("state");
  for (const DoorState known : {DoorState::kUnknown, DoorState::kOpen, DoorState::kClosed}) {
    if (state == wordOf(known)) door.state = known;
  }
  if (!state.empty() && state != wordOf(door.state)) {
    feature.fail("properties.state", "allowed are unknown, open and closed");
  }
  door.properties = feature.properties();
  place.doors.push_back(std::move(door));
}

void readObject(const Feature& feature, GivenPlace& place) {
  ObjectTag object;
  object.name = feature.name("name");
  object.category = feature.name("category");
  object.height = feature.number("height");
  object.properties = feature.properties();
  object.source = TagSource::kManual;
  if (feature.has("position")) {
    object.pose_map = {feature.point("position"), feature.number("yaw")};
    if (feature.has("box")) object.size = feature.point("box");
  } else if (feature.type() == "Point") {
    object.pose_map.position = feature.position();
  } else if (feature.type() == "Polygon" && !feature.rings().empty()) {
    const Polygon ring = feature.rings().front();
    Point2 low = ring.front();
    Point2 high = ring.front();
    for (const Point2& p : ring) low = low.cwiseMin(p), high = high.cwiseMax(p);
    object.pose_map.position = (low + high) / 2;
    object.size = high - low;
  } else {
    feature.fail("geometry.type", "an object is a Point or Polygon");
  }
  if (object.size.minCoeff() < 0 || object.height < 0) feature.fail("properties", "a size below 0");
  place.objects.push_back(std::move(object));
}

Json readJson(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw FileError(FileErrorCode::kPath, path + ": " + std::strerror(errno));
  try {
    Json json = Json::parse(stream);
    if (!json.is_object() || !json.contains("features") || !json["features"].is_array()) {
      throw FileError(FileErrorCode::kIo, path + ": is no FeatureCollection");
    }
    return json;
  } catch (const Json::exception& error) {
    throw FileError(FileErrorCode::kIo, path + ": " + plainText(error.what()));
  }
}

}  // namespace

GivenPlace readGeoJson(const std::string& path, const OccupancyMap& map) {
  const Json collection = readJson(path);
  GivenPlace place;
  place.labels.assign(map.geometry().pixelCount(), 0);
  std::size_t number = 0;
  for (const Json& json : collection["features"]) {
    const Feature feature(path, number++, json);
    const std::string kind = feature.kind();
    if (kind == "area") readArea(feature, map, place);
    if (kind == "door") readDoor(feature, place);
    if (kind == "object") readObject(feature, place);
  }
  return place;
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/exchange/import.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "exchange/border_pieces.h"
#include "exchange/given_overlap.h"

namespace agrid {
namespace {

constexpr int kRounds = 8;           // where areas join, a border between them may need a door
constexpr double kLeastArea = 0.25;  // smaller ones without a name are specks [m^2]
constexpr double kGoodIou = 0.5;     // what is less alike is told
constexpr double kPi = 3.14159265358979323846;

/// Only free pixels are in areas.
std::vector<std::uint16_t> freeLabels(const OccupancyMap& map, const GivenPlace& place) {
  std::vector<std::uint16_t> labels = place.labels;
  const std::size_t pixels = map.geometry().pixelCount();
  if (labels.empty()) labels.assign(pixels, 0);
  if (labels.size() != pixels) {
    throw std::invalid_argument("labels: " + std::to_string(labels.size()) + ", the map has " +
                                std::to_string(pixels) + " pixels");
  }
  for (std::size_t i = 0; i < pixels; ++i) {
    if (map.pixels()[i] != Occupancy::kFree) labels[i] = 0;
    if (labels[i] > place.areas.size()) {
      throw std::invalid_argument("labels: " + std::to_string(labels[i]) + " is more than the " +
                                  std::to_string(place.areas.size()) + " areas");
    }
  }
  return labels;
}

/// Takes away the labels of areas without a name that are too small to be meant.
/// @return how many there were
std::size_t dropSpecks(const OccupancyMap& map, const GivenPlace& place,
                       std::vector<std::uint16_t>& labels) {
  const double pixel = map.geometry().resolution * map.geometry().resolution;
  std::vector<std::size_t> sizes(place.areas.size() + 1, 0);
  for (const std::uint16_t label : labels) ++sizes[label];
  std::vector<bool> is_speck(sizes.size(), false);
  std::size_t specks = 0;
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    is_speck[k] =
        place.areas[k - 1].name.empty() && static_cast<double>(sizes[k]) * pixel < kLeastArea;
    if (is_speck[k]) ++specks;
  }
  for (std::uint16_t& label : labels) {
    if (is_speck[label]) label = 0;
  }
  return specks;
}

/// The pixel that is deepest within those of a given and a found area, as a point of the map.
Point2 deepestPoint(const std::vector<std::uint16_t>& given, std::uint16_t label,
                    const SemanticMap& map, const PixelLabels& found, std::uint16_t area) {
  const MapGeometry& geometry = map.map().geometry();
  cv::Rect box;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i] != label || found[i] != area) continue;
    const Pixel p = geometry.pixel(i);
    box |= cv::Rect(p.x, p.y, 1, 1);
  }
  cv::Mat1b shape(box.height + 2, box.width + 2, std::uint8_t{0});  // with a rim that is outside
  for (int y = 0; y < box.height; ++y) {
    for (int x = 0; x < box.width; ++x) {
      const std::size_t i = geometry.index({box.x + x, box.y + y});
      shape(y + 1, x + 1) = given[i] == label && found[i] == area;
    }
  }
  cv::Mat1f depth;
  cv::distanceTransform(shape, depth, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::Point deepest;
  cv::minMaxLoc(depth, nullptr, nullptr, nullptr, &deepest);
  return geometry.center({box.x + deepest.x - 1, box.y + deepest.y - 1});
}

class TagFitter {
 public:
  TagFitter(const SemanticMap& bare, const GivenPlace& place)
      : bare_(bare),
        place_(place),
        given_(freeLabels(bare.map(), place)),
        specks_(dropSpecks(bare.map(), place, given_)),
        pieces_(findBorderPieces(bare.map(), given_)),
        piece_has_door_(pieces_.size(), false) {}

  FittedTags fit() {
    putGiven();
    Knowledge best = known_;
    double best_iou = -1;
    for (int round = 0; round < kRounds; ++round) {
      const LaidTags laid = lay();
      const GivenOverlap overlap(given_, laid.area_map);
      if (overlap.meanIou() > best_iou) {
        best_iou = overlap.meanIou();
        best = known_;
      }
      const bool joined = joinAreas(laid.area_map, overlap);
      const bool parted = partAreas(laid.area_map);
      if (!joined && !parted) break;
    }
    known_ = std::move(best);
    dropIdleDoors(lay().area_map);
    nameAreas();
    return {std::move(known_), mean_iou_, std::move(warnings_)};
  }

 private:
  LaidTags lay() const {
    return layTags(bare_.map(), bare_.grid(), *bare_.automatic, nullptr, known_);
  }

  void putGiven() {
    for (DoorTag door : place_.doors) {
      door.id = DoorId{known_.next_ids.door};
      apply(PutTag{std::move(door)}, known_);
    }
    first_added_ = known_.next_ids.door;
    for (ObjectTag object : place_.objects) {
      object.id = ObjectId{known_.next_ids.object};
      apply(PutTag{std::move(object)}, known_);
    }
  }

  bool isGiven(DoorId id) const {
    return static_cast<std::uint32_t>(id) < first_added_ && findTag(known_, id) != nullptr;
  }

  /// Says 'no door here' where both sides are in one given area.
  bool joinAreas(const AreaMap& found, const GivenOverlap& overlap) {
    std::map<AreaId, std::uint16_t> main;
    for (std::size_t k = 0; k < found.areas.size(); ++k) {
      main[found.areas[k].id] = overlap.mainOf(static_cast<std::uint16_t>(k + 1));
    }
    bool any = false;
    for (const Door& door : found.doors) {
      const std::uint16_t side = main[door.areas[0]];
      if (side == 0 || side != main[door.areas[1]] || findTag(known_, door.id) != nullptr) continue;
      DoorTag tag;
      tag.id = DoorId{known_.next_ids.door};
      tag.pose_map = poseOf(door);
      tag.width = door.width;
      tag.source = TagSource::kManual;
      tag.absent = true;
      apply(PutTag{std::move(tag)}, known_);
      any = true;
    }
    return any;
  }

  /// Puts doors on borders that run through an area.
  bool partAreas(const AreaMap& found) {
    bool any = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (piece_has_door_[i] || isParted(pieces_[i], found.pixel_labels)) continue;
      piece_has_door_[i] = true;
      const Segment& line = pieces_[i].line_map;
      const Point2 along = line.b - line.a;
      DoorTag tag;
      tag.id = DoorId{known_.next_ids.door};
      tag.pose_map = {line.midpoint(), std::atan2(along.y(), along.x()) - kPi / 2};
      tag.width = line.length();
      tag.source = TagSource::kManual;
      apply(PutTag{std::move(tag)}, known_);
      any = true;
    }
    return any;
  }

  static bool isParted(const BorderPiece& piece, const PixelLabels& found) {
    std::size_t parted = 0;
    std::size_t whole = 0;
    for (const auto& [a, b] : piece.beside) {
      if (found[a] == 0 || found[b] == 0) continue;
      ++(found[a] == found[b] ? whole : parted);
    }
    return whole <= parted;
  }

  /// Doors of ours that part nothing say nothing.
  void dropIdleDoors(const AreaMap& found) {
    std::set<DoorId> parting;
    for (const Door& door : found.doors) {
      if (door.areas[0] != door.areas[1]) parting.insert(door.id);
    }
    const std::vector<DoorTag> doors = known_.doors;
    for (const DoorTag& door : doors) {
      if (door.absent || parting.count(door.id) > 0) continue;
      if (isGiven(door.id)) {
        warnings_.push_back("door '" + door.name + "' parts no areas");
      } else {
        apply(DropTag{TagKind::kDoor, static_cast<std::uint32_t>(door.id)}, known_);
      }
    }
  }

  /// Puts a tag into each given area, the largest first where several are one.
  void nameAreas() {
    const LaidTags laid = lay();
    const GivenOverlap overlap(given_, laid.area_map);
    mean_iou_ = overlap.meanIou();
    if (specks_ > 0) {
      warnings_.push_back(std::to_string(specks_) +
                          " areas without a name have less than 0.25 m^2 of free space and are "
                          "left out");
    }
    std::set<std::uint16_t> taken;
    for (const std::uint16_t label : bySize(overlap)) {
      const GivenArea& area = place_.areas[label - 1U];
      const std::uint16_t best = overlap.bestFor(label);
      const std::string name =
          area.name.empty() ? "number " + std::to_string(label) : "'" + area.name + "'";
      if (best == 0) {
        if (area.name.empty()) continue;
        warnings_.push_back("area " + name + " has no free pixel of the map");
        continue;
      }
      if (overlap.iou(label, best) < kGoodIou) {
        warnings_.push_back("area " + name + " comes out otherwise than it was drawn");
      }
      // what has a name waits for its place, unnamed it would say nothing
      if (!taken.insert(best).second && area.name.empty()) continue;
      AreaTag tag;
      tag.id = AreaId{label};
      tag.name = area.name;
      tag.category = area.category;
      tag.properties = area.properties;
      tag.source = TagSource::kManual;
      tag.seed_map = deepestPoint(given_, label, bare_, laid.area_map.pixel_labels, best);
      apply(PutTag{std::move(tag)}, known_);
    }
  }

  std::vector<std::uint16_t> bySize(const GivenOverlap& overlap) const {
    std::vector<std::uint16_t> labels;
    for (std::size_t k = 1; k <= place_.areas.size(); ++k) {
      labels.push_back(static_cast<std::uint16_t>(k));
    }
    const std::size_t most = given_.empty() ? 0 : *std::max_element(given_.begin(), given_.end());
    const auto sizeOf = [&](std::uint16_t k) { return k > most ? 0 : overlap.givenSize(k); };
    std::stable_sort(labels.begin(), labels.end(),
                     [&](std::uint16_t a, std::uint16_t b) { return sizeOf(a) > sizeOf(b); });
    return labels;
  }

  const SemanticMap& bare_;
  const GivenPlace& place_;
  std::vector<std::uint16_t> given_;
  std::size_t specks_ = 0;
  std::vector<BorderPiece> pieces_;
  std::vector<bool> piece_has_door_;
  Knowledge known_;
  std::uint32_t first_added_ = 1;  ///< doors from this id on are ours
  double mean_iou_ = 1;
  std::vector<std::string> warnings_;
};

}  // namespace

FittedTags fitTags(const SemanticMap& bare, const GivenPlace& place) {
  return TagFitter(bare, place).fit();
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "planning/keep_out.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agrid/areas/area_cost.h"
#include "planning/pixel_walk.h"

namespace agrid::planning {
std::shared_ptr<const KeepOut> KeepOut::of(const AreaMap& areas, const MapGeometry& geometry,
                                           const std::shared_ptr<const KeepOut>& former) {
  std::vector<bool> forbidden(areas.areas.size() + 1);
  for (std::size_t i = 0; i < areas.areas.size(); ++i) {
    forbidden[i + 1] = std::isinf(areaCost(areas.areas[i].properties));
  }
  if (std::find(forbidden.begin(), forbidden.end(), true) == forbidden.end()) return nullptr;
  if (former && former->forbidden_ == forbidden && former->labels_.shares(areas.pixel_labels)) {
    return former;
  }
  return std::shared_ptr<const KeepOut>(
      new KeepOut(geometry, areas.pixel_labels, std::move(forbidden)));
}

KeepOut::KeepOut(const MapGeometry& geometry, PixelLabels labels, std::vector<bool> forbidden)
    : geometry_(geometry),
      labels_(std::move(labels)),
      forbidden_(std::move(forbidden)),
      held_(geometry.pixelCount()) {
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const std::uint16_t label = labels_[i];
    if (!forbidden_[label]) continue;
    held_[i] = true;
    box_of_[label].add(geometry.pixel(i));
  }
}

std::shared_ptr<const KeepOut> KeepOut::without(std::uint16_t label) const {
  auto less = std::shared_ptr<KeepOut>(new KeepOut(*this));
  less->box_of_.erase(label);
  if (less->box_of_.empty()) return nullptr;
  less->forbidden_[label] = false;
  const auto box = box_of_.find(label);
  if (box == box_of_.end()) return less;
  forEachPixel(box->second, [&](Pixel p) {
    const std::size_t i = geometry_.index(p);
    if (labels_[i] == label) less->held_[i] = false;
  });
  return less;
}

bool KeepOut::isTouchedBy(FinePoint a, FinePoint b) const {
  const Point2 low = coordinates(a).cwiseMin(coordinates(b));
  const Point2 high = coordinates(a).cwiseMax(coordinates(b));
  return anyBoxMeets(low, high) &&
         !walkTouched(a, b, [&](Pixel p) { return !held_[geometry_.index(p)]; });
}

bool KeepOut::mayBeNear(const Point2& place_px, double reach) const {
  const Point2 by = Point2::Constant(reach);
  return anyBoxMeets(place_px - by, place_px + by);
}

bool KeepOut::anyBoxMeets(const Point2& low_px, const Point2& high_px) const {
  return std::any_of(box_of_.begin(), box_of_.end(), [&](const auto& entry) {
    const PixelBox& box = entry.second;
    return high_px.x() >= box.low.x - 1 && low_px.x() <= box.high.x + 1 &&
           high_px.y() >= box.low.y - 1 && low_px.y() <= box.high.y + 1;
  });
}

std::vector<PixelBox> KeepOut::boxes() const {
  std::vector<PixelBox> boxes;
  for (const auto& entry : box_of_) boxes.push_back(entry.second);
  return boxes;
}

bool KeepOut::agreesWithin(const PixelBox& box, const KeepOut* other) const {
  bool agrees = true;
  forEachPixel(box, [&](Pixel p) {
    const std::size_t i = geometry_.index(p);
    agrees = agrees && held_[i] == (other != nullptr && other->held_[i]);
  });
  return agrees;
}

std::vector<PixelBox> KeepOut::changedBoxes(const KeepOut* a, const KeepOut* b) {
  std::vector<PixelBox> changed;
  if (a == b) return changed;
  for (const auto& [some, other] : {std::pair{a, b}, {b, a}}) {
    if (some == nullptr) continue;
    for (const PixelBox& box : some->boxes()) {
      if (!some->agreesWithin(box, other)) changed.push_back(box);
    }
  }
  return changed;
}

}  // namespace agrid::planning

// SPDX-License-Identifier: BSD-3-Clause
#include "areas/label_painter.h"

#include <algorithm>
#include <numeric>

namespace agrid {
namespace {

std::size_t indexOf(const AreaMap& areas, AreaId id) {
  const auto found = std::lower_bound(areas.areas.begin(), areas.areas.end(), id,
                                      [](const Area& area, AreaId i) { return area.id < i; });
  return static_cast<std::size_t>(found - areas.areas.begin());
}

}  // namespace

LabelPainter::LabelPainter(const MapGeometry& geometry, const AutomaticAreas& automatic,
                           const FormerTags* former, const std::vector<Area>& areas)
    : geometry_(geometry),
      automatic_(automatic),
      former_(former),
      base_(former ? former->area_map : automatic.area_map) {
  for (std::size_t i = 0; i < areas.size(); ++i) {
    label_of_.emplace(static_cast<std::uint32_t>(areas[i].id), static_cast<std::uint16_t>(i + 1));
  }
}

PixelLabels LabelPainter::paint(const LaidGroups& laid, const SeatedTags& tags) const {
  const std::vector<std::uint16_t> new_label = newLabels(laid, tags);
  bool same = true;
  for (std::size_t i = 0; i < new_label.size(); ++i) same = same && new_label[i] == i;
  const bool painted = std::any_of(laid.groups().begin(), laid.groups().end(),
                                   [this](const LaidGroup& group) { return isPainted(group); });
  if (same && !painted) return base_.pixel_labels;
  std::vector<std::uint16_t> labels = base_.pixel_labels;
  if (!same) {
    std::transform(labels.begin(), labels.end(), labels.begin(),
                   [&](std::uint16_t label) { return new_label[label]; });
  }
  for (std::size_t g = 0; g < tags.size(); ++g) {
    const LaidGroup& group = laid.groups()[g];
    if (!isPainted(group)) continue;
    if (group.parts) {
      paintParts(*group.parts, tags[g], labels);
    } else {
      paintAutomatic(group.group.members.front(), labelOf(tags[g].front()), labels);
    }
  }
  return labels;
}

bool LabelPainter::isPainted(const LaidGroup& group) const {
  return group.parts || (former_ && group.isAutomatic());
}

std::vector<std::uint16_t> LabelPainter::newLabels(const LaidGroups& laid,
                                                   const SeatedTags& tags) const {
  std::vector<std::uint16_t> new_label(base_.areas.size() + 1);
  std::iota(new_label.begin(), new_label.end(), std::uint16_t{0});
  for (const AreaGroup& group : former_ ? former_->groups : std::vector<AreaGroup>()) {
    if (!group.members.empty()) continue;  // what no group takes over has no area
    for (const AreaId id : group.areas) new_label[indexOf(base_, id) + 1] = 0;
  }
  for (std::size_t g = 0; g < tags.size(); ++g) {
    const LaidGroup& group = laid.groups()[g];
    if (isPainted(group)) continue;
    for (std::size_t part = 0; part < tags[g].size(); ++part) {
      const std::size_t label =
          former_ ? indexOf(base_, group.former->areas[part]) + 1 : group.group.members.front();
      new_label[label] = labelOf(tags[g][part]);
    }
  }
  return new_label;
}

std::uint16_t LabelPainter::labelOf(const AreaTag& tag) const {
  return label_of_.at(static_cast<std::uint32_t>(tag.id));
}

void LabelPainter::paintParts(const GroupParts& parts, const std::vector<AreaTag>& tags,
                              std::vector<std::uint16_t>& labels) const {
  std::vector<std::uint16_t> label_of_part{0};
  for (const AreaTag& tag : tags) label_of_part.push_back(labelOf(tag));
  for (int y = 0; y < parts.window.height; ++y) {
    std::uint16_t* row = &labels[geometry_.index({parts.window.x, parts.window.y + y})];
    for (int x = 0; x < parts.window.width; ++x) {
      const int part = parts.part_of(y, x);
      if (part != 0) row[x] = label_of_part[static_cast<std::size_t>(part)];
    }
  }
}

void LabelPainter::paintAutomatic(std::uint16_t automatic_label, std::uint16_t label,
                                  std::vector<std::uint16_t>& labels) const {
  const cv::Rect& box = automatic_.boxes[automatic_label - 1U];
  for (int y = box.y; y < box.br().y; ++y) {
    for (int x = box.x; x < box.br().x; ++x) {
      const std::size_t i = geometry_.index({x, y});
      if (automatic_.area_map.pixel_labels[i] == automatic_label) labels[i] = label;
    }
  }
}

}  // namespace agrid

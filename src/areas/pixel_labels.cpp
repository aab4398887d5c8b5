// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/areas/pixel_labels.h"

#include <algorithm>
#include <numeric>

namespace agrid {

PixelLabels::PixelLabels(std::vector<std::uint16_t> labels) {
  const auto most = std::max_element(labels.begin(), labels.end());
  std::vector<std::int32_t> label_of_slot(most == labels.end() ? 0 : *most + std::size_t{1});
  if (label_of_slot.empty()) label_of_slot.resize(1);
  std::iota(label_of_slot.begin(), label_of_slot.end(), 0);
  data_ = std::make_shared<const Data>(Data{Slots(std::move(labels)), std::move(label_of_slot)});
}

const PixelLabels::Data& PixelLabels::data() const {
  static const Data kNone;
  return data_ ? *data_ : kNone;
}

bool operator==(const PixelLabels& a, const PixelLabels& b) {
  return a.shares(b) || (a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin()));
}

}  // namespace agrid

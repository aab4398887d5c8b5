// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "agrid/map/paged_array.h"

namespace agrid {

/// The label of each pixel of a map. Pixels hold slots, and a table says which label each slot
/// stands for: where areas are numbered anew or are one, no pixel is written. Copies share all;
/// never changed after it was made.
class PixelLabels {
 public:
  using Slots = PagedArray<std::uint16_t, 12>;
  /// In the table: no pixel holds the slot.
  static constexpr std::int32_t kUnused = -1;

  PixelLabels() = default;
  /// Each label is its own slot.
  PixelLabels(std::vector<std::uint16_t> labels);  // NOLINT: labels are what it is
  /// @param label_of_slot  for each slot that a pixel holds a label
  PixelLabels(Slots slots, std::vector<std::int32_t> label_of_slot)
      : data_(std::make_shared<const Data>(Data{std::move(slots), std::move(label_of_slot)})) {}

  std::size_t size() const { return data_ ? data_->slots.size() : 0; }
  std::uint16_t operator[](std::size_t pixel) const {
    return static_cast<std::uint16_t>(data_->label_of_slot[data_->slots[pixel]]);
  }
  /// @throws std::out_of_range
  std::uint16_t at(std::size_t pixel) const {
    if (pixel >= size()) throw std::out_of_range("PixelLabels: no such pixel");
    return (*this)[pixel];
  }
  /// Copies those of `count` pixels from `first` on.
  void copy(std::size_t first, std::size_t count, std::vector<std::uint16_t>& labels) const {
    labels.resize(count);
    for (std::size_t i = 0; i < count; ++i) labels[i] = (*this)[first + i];
  }
  /// All of them, copied.
  std::vector<std::uint16_t> vector() const { return {begin(), end()}; }

  const Slots& slots() const { return data().slots; }
  const std::vector<std::int32_t>& labelOfSlot() const { return data().label_of_slot; }
  /// Whether both are one and the same, which tells it without looking at the pixels.
  bool shares(const PixelLabels& other) const { return data_ == other.data_; }

  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;  // NOLINT: named as the library wants it
    using value_type = std::uint16_t;                     // NOLINT
    using difference_type = std::ptrdiff_t;               // NOLINT
    using pointer = const std::uint16_t*;                 // NOLINT
    using reference = std::uint16_t;                      // NOLINT
    Iterator(const PixelLabels& labels, std::size_t i) : labels_(&labels), i_(i) {}
    std::uint16_t operator*() const { return (*labels_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++i_;
      return before;
    }
    bool operator==(const Iterator& other) const { return i_ == other.i_; }
    bool operator!=(const Iterator& other) const { return i_ != other.i_; }

   private:
    const PixelLabels* labels_;
    std::size_t i_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

  friend bool operator==(const PixelLabels& a, const PixelLabels& b);
  friend bool operator!=(const PixelLabels& a, const PixelLabels& b) { return !(a == b); }

 private:
  struct Data {
    Slots slots;
    std::vector<std::int32_t> label_of_slot;
  };
  const Data& data() const;

  std::shared_ptr<const Data> data_;
};

}  // namespace agrid

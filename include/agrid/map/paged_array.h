// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace agrid {

/// An array of which copies share all pages but those that were changed since: copying takes 8
/// bytes a page, changing an element the copy of its page. Copies may be read and changed by
/// different threads.
template <typename T, unsigned kPageBits>
class PagedArray {
 public:
  PagedArray() : PagedArray(std::vector<T>()) {}
  explicit PagedArray(std::vector<T> values)
      : base_(std::make_shared<const std::vector<T>>(std::move(values))), size_(base_->size()) {
    for (std::size_t first = 0; first < size_; first += kPage) {
      pages_.push_back(base_->data() + first);
    }
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return pages_[i >> kPageBits][i & (kPage - 1)]; }
  /// Valid until the array is changed or ends.
  const T* const* pages() const { return pages_.data(); }
  static const T& at(const T* const* pages, std::size_t i) {
    return pages[i >> kPageBits][i & (kPage - 1)];
  }

  /// To be changed.
  T& edit(std::size_t i) { return ownPage(i >> kPageBits)[i & (kPage - 1)]; }
  void assign(std::size_t first, const std::vector<T>& values) {
    for (std::size_t i = 0; i < values.size();) {
      const std::size_t at = (first + i) & (kPage - 1);
      const std::size_t count = std::min(kPage - at, values.size() - i);
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i), count,
                  ownPage((first + i) >> kPageBits).begin() + static_cast<std::ptrdiff_t>(at));
      i += count;
    }
  }
  void push_back(T value) {  // NOLINT: named as in the standard library
    if (size_ == pages_.size() * kPage) {
      auto& page = own_[pages_.size()];
      page = std::make_shared<std::vector<T>>(kPage);
      pages_.push_back(page->data());
    }
    edit(size_) = std::move(value);
    ++size_;
  }

  /// Calls `visit(i)` where two arrays of the same size differ; pages that they share are passed
  /// over.
  template <typename Visit>
  void forEachDifference(const PagedArray& other, const Visit& visit) const {
    for (std::size_t page = 0; page < pages_.size(); ++page) {
      if (pages_[page] == other.pages_[page]) continue;
      const std::size_t first = page * kPage;
      const std::size_t count = std::min(kPage, size_ - first);
      for (std::size_t i = 0; i < count; ++i) {
        if (pages_[page][i] != other.pages_[page][i]) visit(first + i);
      }
    }
  }

  class Iterator {
   public:
    Iterator(const PagedArray& array, std::size_t i) : array_(&array), i_(i) {}
    const T& operator*() const { return (*array_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return i_ != other.i_; }

   private:
    const PagedArray* array_;
    std::size_t i_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

 private:
  static constexpr std::size_t kPage = std::size_t{1} << kPageBits;

  std::vector<T>& ownPage(std::size_t number) {
    std::shared_ptr<std::vector<T>>& page = own_[number];
    if (page && page.use_count() == 1) {
      // What another owner read before it let go happened before what is written now.
      std::atomic_thread_fence(std::memory_order_acquire);
      return *page;
    }
    const std::size_t count = std::min(kPage, size_ - number * kPage);
    page = std::make_shared<std::vector<T>>(pages_[number], pages_[number] + count);
    page->resize(kPage);
    pages_[number] = page->data();
    return *page;
  }

  std::shared_ptr<const std::vector<T>> base_;
  std::vector<const T*> pages_;  ///< within base_ or own_
  std::map<std::size_t, std::shared_ptr<std::vector<T>>> own_;
  std::size_t size_;
};

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include "map/pixel_values.h"

#include <array>

namespace agrid {
namespace {

constexpr std::size_t kSums = 4 * 255 + 1;
using Table = std::array<std::int8_t, kSums>;  // value by the sum of the samples that count

std::int8_t asByte(double value) {
  return static_cast<std::int8_t>(static_cast<std::uint8_t>(value));  // truncates, 255 becomes -1
}

// map_server's loadMapFromFile, in its order of operations and with its strict comparisons.
std::int8_t valueOf(double average, const PixelRule& rule, bool transparent) {
  if (rule.negate) average = 255 - average;
  if (rule.mode == PixelMode::kRaw) return asByte(average);
  const double darkness = (255 - average) / 255.0;
  if (darkness > rule.occupied_thresh) return 100;
  if (darkness < rule.free_thresh) return 0;
  if (rule.mode == PixelMode::kTrinary || transparent) return -1;
  return asByte(1 +
                98 * ((darkness - rule.free_thresh) / (rule.occupied_thresh - rule.free_thresh)));
}

Table tableFor(int samples, const PixelRule& rule, bool transparent) {
  Table table{};
  for (std::size_t sum = 0; sum <= static_cast<std::size_t>(samples) * 255; ++sum) {
    table[sum] = valueOf(static_cast<double>(sum) / samples, rule, transparent);
  }
  return table;
}

bool isOpaque(const Image& image) {
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t alpha = channels - 1; alpha < image.rows.size(); alpha += channels) {
    if (image.rows[alpha] != 255) return false;
  }
  return true;
}

/// How many of a pixel's samples make its value.
int samplesThatCount(const Image& image, const PixelRule& rule) {
  if (!image.alpha_mask) return image.channels;
  // map_server averages the transparency with the colours in trinary mode.
  const bool all_count =
      rule.mode == PixelMode::kTrinary && !(rule.skip_opaque_alpha && isOpaque(image));
  return all_count ? image.channels : image.channels - 1;
}

}  // namespace

std::vector<std::int8_t> pixelValues(const Image& image, const PixelRule& rule) {
  const int samples = samplesThatCount(image, rule);
  const Table opaque = tableFor(samples, rule, false);
  const Table transparent = tableFor(samples, rule, true);
  const std::size_t row_bytes = image.rowBytes();
  std::vector<std::int8_t> values;
  values.reserve(image.rows.size() / static_cast<std::size_t>(image.channels));
  for (int y = image.height - 1; y >= 0; --y) {
    const std::uint8_t* pixel = image.rows.data() + static_cast<std::size_t>(y) * row_bytes;
    const std::uint8_t* const end = pixel + row_bytes;
    if (image.channels == 1) {
      for (; pixel != end; ++pixel) values.push_back(opaque[*pixel]);
    }
    for (; pixel != end; pixel += image.channels) {
      std::size_t sum = 0;
      for (int k = 0; k < samples; ++k) sum += pixel[k];
      // It takes the last sample for the transparency even where that is a colour.
      values.push_back(pixel[image.channels - 1] == 0 ? transparent[sum] : opaque[sum]);
    }
  }
  return values;
}

}  // namespace agrid

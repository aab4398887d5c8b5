// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "map/image.h"

namespace agrid {
namespace {

using Colour = std::array<std::uint8_t, 3>;  // blue, green, red, as in the file

struct Header {
  std::uint64_t pixel_offset = 0;
  std::uint64_t info_size = 0;
  std::int64_t width = 0;
  std::int64_t height = 0;
  bool top_down = false;
  int bits = 0;  // per pixel
  std::uint32_t compression = 0;
  std::uint32_t colours = 0;  // of the palette

  bool hasPalette() const { return bits <= 8; }
  std::uint64_t rowBytes() const {
    return (static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(bits) + 7) / 8;
  }
  std::uint64_t stride() const { return (rowBytes() + 3) / 4 * 4; }
};

std::uint32_t takeNumber(FileReader& file, int bytes) {
  std::uint32_t number = 0;
  for (int i = 0; i < bytes; ++i) {
    const auto byte = file.take();
    if (!byte) file.fail(FileErrorCode::kImage, "truncated inside the BMP header");
    number |= static_cast<std::uint32_t>(*byte) << (8 * i);
  }
  return number;
}

std::int32_t takeSigned(FileReader& file) { return static_cast<std::int32_t>(takeNumber(file, 4)); }

Header takeHeader(FileReader& file) {
  Header header;
  file.skip(10);
  header.pixel_offset = takeNumber(file, 4);
  header.info_size = takeNumber(file, 4);
  if (header.info_size == 12) {
    header.width = takeNumber(file, 2);
    header.height = takeNumber(file, 2);
    file.skip(2);
    header.bits = static_cast<int>(takeNumber(file, 2));
    return header;
  }
  header.width = takeSigned(file);
  const std::int64_t height = takeSigned(file);
  header.top_down = height < 0;
  header.height = height < 0 ? -height : height;
  file.skip(2);
  header.bits = static_cast<int>(takeNumber(file, 2));
  header.compression = takeNumber(file, 4);
  file.skip(12);
  header.colours = takeNumber(file, 4);
  file.skip(4);
  return header;
}

void checkHeader(const FileReader& file, const Header& header, double max_pixels) {
  const auto refuse = [&file](const std::string& what) {
    file.fail(FileErrorCode::kImage, "BMP " + what);
  };
  if (header.info_size != 12 && (header.info_size < 40 || header.info_size > 124)) {
    refuse("header of " + std::to_string(header.info_size) + " bytes is not known");
  }
  if (header.compression != 0) refuse("compression and bit fields are not supported");
  if (header.bits != 1 && header.bits != 4 && header.bits != 8 && header.bits != 24 &&
      header.bits != 32) {
    refuse("with " + std::to_string(header.bits) +
           " bits per pixel is not supported: 1, 4, 8, 24 and 32 are");
  }
  checkImageSize(file, header.width, header.height, max_pixels);
  if (header.hasPalette() && header.colours > (1u << header.bits)) refuse("palette is too long");
  if (header.pixel_offset < 14 + header.info_size) refuse("pixels overlap the header");
  const std::uint64_t need =
      header.stride() * static_cast<std::uint64_t>(header.height - 1) + header.rowBytes();
  const std::uint64_t have = file.size() - std::min(file.size(), header.pixel_offset);
  if (need > have) {
    refuse("truncated: the pixels need " + std::to_string(need) + " bytes, the file has " +
           std::to_string(have));
  }
}

std::vector<Colour> takePalette(FileReader& file, const Header& header) {
  if (!header.hasPalette()) return {};
  file.skip(14 + header.info_size - file.offset());
  const std::size_t count = header.colours == 0 ? std::size_t{1} << header.bits : header.colours;
  const std::uint64_t entry_bytes = header.info_size == 12 ? 3 : 4;
  if (file.offset() + count * entry_bytes > header.pixel_offset) {
    file.fail(FileErrorCode::kImage, "BMP palette overlaps the pixels");
  }
  std::vector<Colour> palette(count);
  for (Colour& colour : palette) {
    file.read(colour.data(), colour.size());
    file.skip(entry_bytes - colour.size());
  }
  return palette;
}

bool isGreyRamp(const std::vector<Colour>& palette) {
  for (std::size_t i = 0; i < palette.size(); ++i) {
    for (const std::uint8_t value : palette[i]) {
      if (value != i) return false;
    }
  }
  return true;
}

// One row as in the file to indices, the leftmost pixel in the highest bits.
void unpackRow(const std::uint8_t* packed, int bits, std::vector<std::uint8_t>& indices) {
  const auto per_byte = static_cast<std::size_t>(8 / bits);
  const int mask = (1 << bits) - 1;
  for (std::size_t x = 0; x < indices.size(); ++x) {
    const int shift = 8 - bits * static_cast<int>(x % per_byte + 1);
    indices[x] = static_cast<std::uint8_t>((packed[x / per_byte] >> shift) & mask);
  }
}

// Indices that lie outside the palette have no colour.
void colourRow(const FileReader& file, const std::vector<std::uint8_t>& indices,
               const std::vector<Colour>& palette, Image& image, std::uint8_t* row) {
  for (const std::uint8_t index : indices) {
    if (index >= palette.size()) {
      file.fail(FileErrorCode::kImage, "BMP pixel of colour " + std::to_string(index) +
                                           ", the palette has " + std::to_string(palette.size()));
    }
    if (image.channels == 1) {
      *row++ = index;
    } else {
      row = std::copy(palette[index].begin(), palette[index].end(), row);
    }
  }
}

void readRows(FileReader& file, const Header& header, const std::vector<Colour>& palette,
              Image& image) {
  std::vector<std::uint8_t> packed(header.stride());
  std::vector<std::uint8_t> indices(header.hasPalette() ? static_cast<std::size_t>(image.width)
                                                        : 0);
  for (int i = 0; i < image.height; ++i) {
    if (file.read(packed.data(), packed.size()) < header.rowBytes()) {
      file.fail(FileErrorCode::kImage, "BMP truncated in its pixels");
    }
    std::uint8_t* row = image.row(header.top_down ? i : image.height - 1 - i);
    if (header.hasPalette()) {
      unpackRow(packed.data(), header.bits, indices);
      colourRow(file, indices, palette, image, row);
      continue;
    }
    const auto pixel_bytes = static_cast<std::size_t>(header.bits / 8);
    for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
      row = std::copy_n(packed.data() + x * pixel_bytes, 3, row);
    }
  }
}

}  // namespace

Image readBmp(FileReader& file, double max_pixels) {
  const Header header = takeHeader(file);
  checkHeader(file, header, max_pixels);
  const std::vector<Colour> palette = takePalette(file, header);
  Image image;
  image.width = static_cast<int>(header.width);
  image.height = static_cast<int>(header.height);
  image.channels = header.hasPalette() && isGreyRamp(palette) ? 1 : 3;
  image.rows.resize(image.rowBytes() * static_cast<std::size_t>(image.height));
  file.skip(header.pixel_offset - file.offset());
  readRows(file, header, palette, image);
  if (header.hasPalette() && image.channels == 3) {
    image.warnings.push_back(
        "palette image read by its colours; map_server takes the palette's indices as greys");
  }
  if (header.bits == 32) {
    image.warnings.push_back(
        "32-bit BMP read without its fourth bytes; map_server averages them with the colours");
  }
  warnOfTrailingBytes(file, image);
  return image;
}

}  // namespace agrid

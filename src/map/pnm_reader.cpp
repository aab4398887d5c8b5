// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "map/image.h"

namespace agrid {
namespace {

struct Header {
  char kind = '5';  // '1'..'6', the digit of the magic number
  std::int64_t width = 0;
  std::int64_t height = 0;
  std::int64_t maxval = 1;

  bool isAscii() const { return kind <= '3'; }
  bool isBitmap() const { return kind == '1' || kind == '4'; }
  int channels() const { return kind == '3' || kind == '6' ? 3 : 1; }
  std::uint64_t samples() const {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
           static_cast<std::uint64_t>(channels());
  }
  // The least the pixels can take in the file.
  std::uint64_t minBytes() const {
    if (kind == '1') return samples();
    if (isAscii()) return 2 * samples() - 1;
    if (isBitmap()) return static_cast<std::uint64_t>((width + 7) / 8 * height);
    return samples();
  }
};

bool isSpace(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool isDigit(std::uint8_t c) { return c >= '0' && c <= '9'; }

void skipComment(FileReader& file) {
  while (const auto c = file.take()) {
    if (*c == '\n' || *c == '\r') return;
  }
}

void skipSpaceAndComments(FileReader& file) {
  while (const auto c = file.peek()) {
    if (!isSpace(*c) && *c != '#') return;
    file.take();
    if (*c == '#') skipComment(file);
  }
}

std::int64_t readNumber(FileReader& file, const char* what) {
  skipSpaceAndComments(file);
  std::int64_t number = 0;
  int digits = 0;
  for (auto c = file.peek(); c && isDigit(*c); c = file.peek()) {
    if (++digits > 9) file.fail(FileErrorCode::kImage, std::string(what) + " has over 9 digits");
    number = 10 * number + (*c - '0');
    file.take();
  }
  if (digits > 0) return number;
  file.fail(FileErrorCode::kImage,
            std::string(what) + (file.peek()
                                     ? " is not a number, at byte " + std::to_string(file.offset())
                                     : " is missing: the file ends before it"));
}

// Exactly one space divides the header from binary pixels, and a comment may stand before it.
void skipEndOfHeader(FileReader& file, const Header& header, Image& image) {
  const auto c = file.take();
  if (c && *c == '#') return skipComment(file);
  if (!c || !isSpace(*c)) {
    file.fail(FileErrorCode::kImage,
              "no space after the header, at byte " + std::to_string(file.offset()));
  }
  if (header.isAscii() || *c != '\r' || file.peek() != std::uint8_t{'\n'}) return;
  const std::uint64_t surplus = file.remaining() - std::min(file.remaining(), header.minBytes());
  if (surplus > 1) {
    file.fail(FileErrorCode::kImage, "CR LF after the header and " + std::to_string(surplus) +
                                         " bytes too many: where the pixels start cannot be told");
  }
  if (surplus == 0) return;  // the LF is the first pixel
  file.take();
  image.warnings.push_back(
      "the header ends with CR LF; map_server takes the LF as a pixel and shifts the image by one");
}

void checkMaxval(const FileReader& file, const Header& header) {
  if (header.maxval >= 1 && header.maxval <= 255) return;
  const std::string text = "maxval is " + std::to_string(header.maxval);
  file.fail(FileErrorCode::kImage,
            header.maxval > 255 && header.maxval < 65536
                ? text + ": 16-bit samples are not supported in PNM files, by map_server neither"
                : text + ", must be in [1, 255]");
}

Header readHeader(FileReader& file, double max_pixels, Image& image) {
  Header header;
  header.kind = static_cast<char>((file.take(), *file.take()));
  header.width = readNumber(file, "width");
  header.height = readNumber(file, "height");
  checkImageSize(file, header.width, header.height, max_pixels);
  if (!header.isBitmap()) {
    header.maxval = readNumber(file, "maxval");
    checkMaxval(file, header);
  }
  skipEndOfHeader(file, header, image);
  if (header.minBytes() > file.remaining()) {
    file.fail(FileErrorCode::kImage,
              "truncated: the pixels need " + std::to_string(header.minBytes()) +
                  " bytes, the file has " + std::to_string(file.remaining()));
  }
  return header;
}

[[noreturn]] void failTruncated(const FileReader& file, std::uint64_t have, std::uint64_t need) {
  file.fail(FileErrorCode::kImage,
            "truncated: " + std::to_string(have) + " of " + std::to_string(need) + " samples");
}

void readAscii(FileReader& file, const Header& header, Image& image) {
  for (std::uint8_t& sample : image.rows) {
    skipSpaceAndComments(file);
    if (!file.peek()) {
      failTruncated(file, static_cast<std::uint64_t>(&sample - image.rows.data()),
                    header.samples());
    }
    std::int64_t value = 0;
    if (header.isBitmap()) {  // the digits need no space between them
      value = *file.take() - '0';
    } else {
      value = readNumber(file, "a sample");
    }
    if (value < 0 || value > header.maxval) {
      file.fail(FileErrorCode::kImage, "a sample before byte " + std::to_string(file.offset()) +
                                           " lies outside [0, " + std::to_string(header.maxval) +
                                           "]");
    }
    sample = static_cast<std::uint8_t>(value);
  }
  skipSpaceAndComments(file);
}

void readBits(FileReader& file, const Header& header, Image& image) {
  std::vector<std::uint8_t> packed(static_cast<std::size_t>((header.width + 7) / 8));
  for (int y = 0; y < image.height; ++y) {
    if (file.read(packed.data(), packed.size()) != packed.size()) {
      failTruncated(file, static_cast<std::uint64_t>(y) * image.rowBytes(), header.samples());
    }
    std::uint8_t* row = image.row(y);
    for (std::size_t x = 0; x < image.rowBytes(); ++x) {
      row[x] = (packed[x / 8] >> (7 - x % 8)) & 1;
    }
  }
}

// Samples above maxval wrap as map_server's do.
void scaleToBytes(const Header& header, Image& image) {
  std::array<std::uint8_t, 256> scaled{};
  for (std::size_t v = 0; v < 256; ++v) {
    const auto maxval = static_cast<std::size_t>(header.maxval);
    scaled[v] =
        static_cast<std::uint8_t>(header.isBitmap() ? (v == 0 ? 255 : 0) : v * 255 / maxval);
  }
  std::size_t above = 0;
  for (std::uint8_t& sample : image.rows) {
    above += sample > header.maxval ? 1 : 0;
    sample = scaled[sample];
  }
  if (above > 0) {
    image.warnings.push_back(std::to_string(above) + " samples exceed maxval " +
                             std::to_string(header.maxval) +
                             "; they are taken modulo 256, as by map_server");
  }
}

}  // namespace

Image readPnm(FileReader& file, double max_pixels) {
  Image image;
  const Header header = readHeader(file, max_pixels, image);
  image.width = static_cast<int>(header.width);
  image.height = static_cast<int>(header.height);
  image.channels = header.channels();
  image.rows.resize(header.samples());
  if (header.isAscii()) {
    readAscii(file, header, image);
  } else if (header.isBitmap()) {
    readBits(file, header, image);
  } else {
    const std::size_t have = file.read(image.rows.data(), image.rows.size());
    if (have != image.rows.size()) failTruncated(file, have, header.samples());
  }
  if (header.maxval < 255) scaleToBytes(header, image);
  if (header.isBitmap()) {
    image.warnings.push_back(
        "1-bit image read by its colours; map_server takes every pixel of it as nearly black");
  }
  warnOfTrailingBytes(file, image);
  return image;
}

}  // namespace agrid

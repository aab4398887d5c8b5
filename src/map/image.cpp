// SPDX-License-Identifier: BSD-3-Clause
#include "map/image.h"

#include <array>
#include <limits>
#include <string_view>

namespace agrid {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  std::string_view name;
};
constexpr std::array<Signature, 7> kNotRead = {{{"\xFF\xD8\xFF"sv, "JPEG"},
                                                {"GIF8"sv, "GIF"},
                                                {"II*\0"sv, "TIFF"},
                                                {"MM\0*"sv, "TIFF"},
                                                {"RIFF"sv, "RIFF (WebP)"},
                                                {"P7"sv, "PAM (P7)"},
                                                {"\0\0\1\0"sv, "ICO"}}};

bool startsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

}  // namespace

void checkImageSize(const FileReader& file, std::int64_t width, std::int64_t height,
                    double max_pixels) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  constexpr std::int64_t kLongest = std::numeric_limits<std::int32_t>::max();
  if (width <= 0 || height <= 0) {
    file.fail(FileErrorCode::kImage, "image of " + size + " pixels: both sides must be positive");
  }
  if (width > kLongest || height > kLongest ||
      !(static_cast<double>(width) * static_cast<double>(height) <= max_pixels)) {
    file.fail(FileErrorCode::kImage, "image of " + size + " pixels: more than max_pixels = " +
                                         std::to_string(static_cast<std::int64_t>(max_pixels)));
  }
}

void warnOfTrailingBytes(const FileReader& file, Image& image) {
  if (file.remaining() == 0) return;
  image.warnings.push_back(std::to_string(file.remaining()) +
                           " bytes after the image are left out");
}

Image readImage(FileReader& file, double max_pixels) {
  // The longest signature has 8 bytes; reading them must not move the file on.
  const std::string start = file.start(8);
  if (startsWith(start, "\x89PNG\r\n\x1A\n"sv)) return readPng(file, max_pixels);
  if (startsWith(start, "BM"sv)) return readBmp(file, max_pixels);
  if (start.size() > 1 && start[0] == 'P' && start[1] >= '1' && start[1] <= '6') {
    return readPnm(file, max_pixels);
  }
  for (const Signature& signature : kNotRead) {
    if (startsWith(start, signature.bytes)) {
      file.fail(FileErrorCode::kImage, "format " + std::string(signature.name) +
                                           " not supported; PNG, PBM, PGM, PPM and BMP are");
    }
  }
  file.fail(FileErrorCode::kImage, start.empty()
                                       ? "the file is empty"
                                       : "not an image: PNG, PBM, PGM, PPM and BMP are read");
}

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "map/file_reader.h"

namespace agrid {

/// A decoded image: 8 bits per sample, in the byte order in which map_server sees it.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 1;                ///< bytes per pixel, 1 to 4
  bool alpha_mask = false;         ///< map_server knows the last channel to be the transparency
  std::vector<std::uint8_t> rows;  ///< row-major, the top row first
  std::vector<std::string> warnings;

  std::size_t rowBytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
  }
  std::uint8_t* row(int y) { return rows.data() + static_cast<std::size_t>(y) * rowBytes(); }
};

/// Decodes a PNG, PBM, PGM, PPM or BMP file, told apart by its content.
/// @throws FileError (kImage, kIo)
Image readImage(FileReader& file, double max_pixels);

/// The readers of one format each; the file stands at its start.
Image readPng(FileReader& file, double max_pixels);
Image readPnm(FileReader& file, double max_pixels);
Image readBmp(FileReader& file, double max_pixels);

/// @throws FileError (kImage) if a side is not positive or the image has more than `max_pixels`
void checkImageSize(const FileReader& file, std::int64_t width, std::int64_t height,
                    double max_pixels);

/// Notes what follows the image in the file.
void warnOfTrailingBytes(const FileReader& file, Image& image);

}  // namespace agrid

// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <csetjmp>
#include <exception>
#include <new>

#include <png.h>

#include "map/image.h"

namespace agrid {
namespace {

constexpr std::size_t kMostWarnings = 4;

// Owns libpng's structures. libpng reports errors by longjmp, which no C++ object may be between.
class PngDecoder {
 public:
  explicit PngDecoder(FileReader& file) : file_(file) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, this, onRead);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    leaveOutAncillaryChunks();
  }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

  png_structp png() const { return png_; }
  png_infop info() const { return info_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::string& error() const { return error_; }

  // Runs libpng calls; `step` may hold nothing that needs destruction. False after an error.
  template <typename Step>
  bool tried(const Step& step) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    step();
    return true;
  }
  template <typename Step>
  void run(const Step& step) {
    if (tried(step)) return;
    if (failure_) std::rethrow_exception(failure_);
    file_.fail(FileErrorCode::kImage, "PNG: " + error_);
  }

 private:
  // None of them changes the pixels map_server sees; some can be made to inflate without bound.
  void leaveOutAncillaryChunks() {
    static constexpr char kNames[] =
        "bKGD\0cHRM\0eXIf\0gAMA\0hIST\0iCCP\0iTXt\0oFFs\0pCAL\0pHYs\0sBIT\0sCAL\0sPLT\0sRGB\0"
        "tEXt\0tIME\0zTXt";
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER,
                                reinterpret_cast<png_const_bytep>(kNames),
                                static_cast<int>(sizeof kNames / 5));
  }
  static void onError(png_structp png, png_const_charp message) {
    static_cast<PngDecoder*>(png_get_error_ptr(png))->error_ = message;
    png_longjmp(png, 1);
  }
  static void onWarning(png_structp png, png_const_charp message) {
    auto& warnings = static_cast<PngDecoder*>(png_get_error_ptr(png))->warnings_;
    if (warnings.size() < kMostWarnings) warnings.push_back(std::string("PNG: ") + message);
  }
  static void onRead(png_structp png, png_bytep bytes, std::size_t size) {
    auto* decoder = static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (!decoder->readWhole(bytes, size)) png_error(png, "truncated: the file ends too early");
  }
  bool readWhole(png_bytep bytes, std::size_t size) {
    try {
      return file_.read(bytes, size) == size;
    } catch (...) {  // thrown again once libpng has unwound
      failure_ = std::current_exception();
      return false;
    }
  }

  FileReader& file_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string error_;
  std::exception_ptr failure_;
  std::vector<std::string> warnings_;
};

// map_server's decoder leaves a palette as it is unless several colours are translucent.
bool mapServerTakesIndices(png_structp png, png_infop info) {
  png_bytep alpha = nullptr;
  int count = 0;
  if ((png_get_tRNS(png, info, &alpha, &count, nullptr) & PNG_INFO_tRNS) == 0) return true;
  int transparent = 0;
  for (int i = 0; i < count; ++i) {
    if (alpha[i] != 0 && alpha[i] != 255) return false;
    transparent += alpha[i] == 0 ? 1 : 0;
  }
  return transparent <= 1;
}

bool isGreyRamp(png_structp png, png_infop info) {
  png_colorp colours = nullptr;
  int count = 0;
  png_get_PLTE(png, info, &colours, &count);
  for (int i = 0; i < count; ++i) {
    if (colours[i].red != i || colours[i].green != i || colours[i].blue != i) return false;
  }
  return true;
}

// Adds to libpng's transformations those that SDL_image 1.2, map_server's decoder, asks for.
void configure(PngDecoder& decoder, Image& image) {
  png_structp png = decoder.png();
  png_infop info = decoder.info();
  const int type = png_get_color_type(png, info);
  const bool transparent = png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  bool expand = type == PNG_COLOR_TYPE_GRAY;
  if (type == PNG_COLOR_TYPE_PALETTE) {
    const bool indices = mapServerTakesIndices(png, info);
    expand = transparent || !indices || !isGreyRamp(png, info);
    if (expand && indices) {
      image.warnings.push_back(
          "palette image read by its colours; map_server takes the palette's indices as greys");
    }
  }
  if (png_get_bit_depth(png, info) == 16) {
    image.warnings.push_back("16-bit samples: their high bytes are used, as by map_server");
  }
  decoder.run([png, info, type, expand] {
    png_set_strip_16(png);
    png_set_packing(png);
    if (expand) png_set_expand(png);
    if (type == PNG_COLOR_TYPE_GRAY_ALPHA) png_set_gray_to_rgb(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
  });
}

// Deflate shrinks at most 1032 times, so a short file that declares a vast image is known to be
// truncated before anything is allocated for it.
void checkFileCanHoldImage(const FileReader& file, std::uint64_t row_bytes, std::uint64_t rows) {
  constexpr std::uint64_t kMostRatio = 1032;
  if (row_bytes * rows / kMostRatio <= file.size()) return;
  file.fail(FileErrorCode::kImage, "truncated: the image declares " +
                                       std::to_string(row_bytes * rows) + " bytes, which the " +
                                       std::to_string(file.size()) +
                                       " bytes of the file cannot hold");
}

void readRows(PngDecoder& decoder, Image& image) {
  png_structp png = decoder.png();
  const int passes = png_get_interlace_type(png, decoder.info()) == PNG_INTERLACE_ADAM7 ? 7 : 1;
  std::uint8_t* const first = image.rows.data();
  const std::size_t stride = image.rowBytes();
  const int height = image.height;
  decoder.run([=] {
    for (int pass = 0; pass < passes; ++pass) {
      for (int y = 0; y < height; ++y) {
        png_read_row(png, first + static_cast<std::size_t>(y) * stride, nullptr);
      }
    }
  });
}

}  // namespace

Image readPng(FileReader& file, double max_pixels) {
  PngDecoder decoder(file);
  png_structp png = decoder.png();
  png_infop info = decoder.info();
  decoder.run([png, info] { png_read_info(png, info); });
  const std::int64_t width = png_get_image_width(png, info);
  const std::int64_t height = png_get_image_height(png, info);
  checkImageSize(file, width, height, max_pixels);
  checkFileCanHoldImage(file, png_get_rowbytes(png, info), static_cast<std::uint64_t>(height));

  Image image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  configure(decoder, image);
  image.channels = png_get_channels(png, info);
  image.alpha_mask = image.channels == 4;
  image.rows.resize(image.rowBytes() * static_cast<std::size_t>(height));
  readRows(decoder, image);
  if (!decoder.tried([png] { png_read_end(png, nullptr); })) {
    image.warnings.push_back("PNG: damaged after the pixels: " + decoder.error());
  }
  image.warnings.insert(image.warnings.end(), decoder.warnings().begin(), decoder.warnings().end());
  warnOfTrailingBytes(file, image);
  return image;
}

}  // namespace agrid

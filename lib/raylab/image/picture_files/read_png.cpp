#include "raylab/image/picture_files/read_png.h"

#include "raylab/base/bytes.h"
#include "raylab/image/check_picture_size.h"
#include "raylab/image/color.h"
#include "raylab/image/png_chunks.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <vector>

namespace raylab {

namespace {

/// libpng with error handlers of our own, because its default ones print.
class PngReader {
public:
    explicit PngReader(std::string_view bytes)
        : left_(bytes),
          png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, keep_reason, ignore_warning)),
          info_(png_create_info_struct(png_)) {
        png_set_read_fn(png_, this, take_bytes);
        // These chunks are not needed, and some contain compressed texts of any size.
        constexpr png_byte ignored[] =
            "iCCP\0tEXt\0zTXt\0iTXt\0sPLT\0hIST\0eXIf";  // each name ends with a NUL, as the call requires
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, ignored, sizeof ignored / 5);
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    bool read_header() {
        return completes([this] { png_read_info(png_, info_); });
    }
    int width() const { return static_cast<int>(png_get_image_width(png_, info_)); }
    int height() const { return static_cast<int>(png_get_image_height(png_, info_)); }
    int bits() const { return png_get_bit_depth(png_, info_) == 16 ? 16 : 8; }

    /// Reads three values for each pixel, of bits() each.
    bool read_rows(std::vector<png_bytep>& rows) {
        return completes([&] {
            png_set_palette_to_rgb(png_);
            if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(png_);
            png_set_gray_to_rgb(png_);
            png_set_strip_alpha(png_);
            png_read_update_info(png_, info_);
            png_read_image(png_, rows.data());
        });
    }
    const std::string& reason() const { return reason_; }

private:
    // A failing step leaves libpng by longjmp, so nothing inside a step may have a destructor.
    template <class Step>
    bool completes(const Step& step) {
        if (setjmp(png_jmpbuf(png_))) return false;
        step();
        return true;
    }
    [[noreturn]] static void keep_reason(png_structp png, png_const_charp message) {
        static_cast<PngReader*>(png_get_error_ptr(png))->reason_ = message;
        png_longjmp(png, 1);
    }
    static void ignore_warning(png_structp, png_const_charp) {}
    static void take_bytes(png_structp png, png_bytep to, std::size_t count) {
        auto& left = static_cast<PngReader*>(png_get_io_ptr(png))->left_;
        if (count > left.size()) png_error(png, "the end of the file");
        std::copy_n(left.begin(), count, to);
        left.remove_prefix(count);
    }

    std::string_view left_;
    std::string reason_;
    png_structp png_;
    png_infop info_;
};

// The linear light of every code value.
std::vector<float> decoded_codes(int bits) {
    std::vector<float> light(std::size_t{1} << bits);
    for (std::size_t code = 0; code < light.size(); ++code)
        light[code] =
            static_cast<float>(linear_from_srgb(static_cast<double>(code) / static_cast<double>(light.size() - 1)));
    return light;
}

Image image_of(std::string_view bytes, int width, int height, int bits) {
    const auto light = decoded_codes(bits);
    Image image(width, height);
    std::size_t next = 0;
    const auto value = [&] {
        const std::size_t at = next++;
        return light[bits == 16 ? number_at<std::uint16_t>(bytes, 2 * at, std::endian::big)
                                : number_at<std::uint8_t>(bytes, at, std::endian::big)];
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Pixel& pixel = image.at(x, y);
            pixel.r = value(), pixel.g = value(), pixel.b = value();
        }
    return image;
}

}  // namespace

Image read_png(std::string_view bytes, const std::string& file, const MemoryLimit& limit) {
    if (const auto damage = png_damage(bytes); !damage.empty()) throw Error({file}, "a whole PNG picture", damage);
    PngReader reader(bytes);
    const auto refuse = [&] { throw Error({file}, "a whole picture that can be read", reader.reason()); };
    if (!reader.read_header()) refuse();
    const auto value_bytes = static_cast<std::size_t>(reader.bits()) / 8;
    const std::size_t row = 3 * value_bytes * static_cast<std::size_t>(reader.width());
    check_picture_size({.width = reader.width(),
                        .height = reader.height(),
                        .file_bytes = bytes.size(),
                        .buffers = static_cast<double>(row) * reader.height(),
                        .what = fmt::format("3 values of {} bits", reader.bits())},
                       file, limit);
    std::string values(row * static_cast<std::size_t>(reader.height()), '\0');
    std::vector<png_bytep> rows;
    for (std::size_t at = 0; at < values.size(); at += row)
        rows.push_back(reinterpret_cast<png_bytep>(values.data() + at));
    if (!reader.read_rows(rows)) refuse();
    return image_of(values, reader.width(), reader.height(), reader.bits());
}

}  // namespace raylab

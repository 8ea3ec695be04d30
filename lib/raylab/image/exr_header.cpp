#include "raylab/image/exr_header.h"

#include "raylab/base/bytes.h"
#include "raylab/base/error.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string>

// The layout of an OpenEXR file: magic number, version and flags, attributes (name, type, size, value) up to an empty
// name; a file of several parts has such a header for each, up to an empty one.

namespace raylab {

namespace {

constexpr std::size_t max_attributes =
    4096;  // in all; OpenEXR's own lists are searched whenever they grow. Renderers write some 50
constexpr std::int64_t max_channels = 1024;  // the limit of OpenImageIO
constexpr std::size_t longest_name = 255;
constexpr std::uint32_t is_deep = 0x800, has_parts = 0x1000;

class HeaderReader {
public:
    explicit HeaderReader(const std::filesystem::path& path)
        : name_(path.string()),
          file_(path, std::ios::binary),
          size_(static_cast<std::int64_t>(std::filesystem::file_size(path))) {}

    ExrHeader read() {
        skip(4);  // the magic number
        const auto flags = number<std::uint32_t>();
        if ((flags & is_deep) != 0) refuse("a flat picture", "a deep one");
        const ExrHeader first = read_part();
        if ((flags & has_parts) != 0)
            while (!ends_here()) read_part();
        return first;
    }

private:
    ExrHeader read_part() {
        ExrHeader header;
        for (auto name = text(); !name.empty(); name = text()) {
            if (++attributes_ > max_attributes) refuse(fmt::format("at most {} attributes", max_attributes), "more");
            text();  // the type
            const std::int64_t size = number<std::int32_t>();
            if (size < 0 || size > left())
                refuse(fmt::format("an attribute of at most {} bytes (what is left)", left()),
                       fmt::format("{} bytes", size));
            const std::int64_t end = at_ + size;
            read_attribute(name, size, header);
            go_to(end);
        }
        check_chunks(header);
        return header;
    }

    void read_attribute(const std::string& name, std::int64_t size, ExrHeader& header) {
        constexpr std::array lines{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};  // none, RLE, ZIPS, ZIP, PIZ, ..., DWAB
        if (name == "channels") read_channels(at_ + size, header);
        if (name == "dataWindow" && size == 16) {
            const std::int64_t left = number<std::int32_t>(), top = number<std::int32_t>();
            header.width = number<std::int32_t>() - left + 1;
            header.height = number<std::int32_t>() - top + 1;
        }
        if (name == "compression" && size == 1) {
            const auto kind = number<std::uint8_t>();
            header.chunk_lines = kind < lines.size() ? lines[kind] : lines.back();
        }
        if (name == "tiles" && size == 9) {
            header.tile_width = number<std::uint32_t>();
            header.tile_height = number<std::uint32_t>();
        }
    }

    // Each channel has a name, its type (0 and 2 have four bytes, 1 two) and three numbers; the list ends with an empty
    // name.
    void read_channels(std::int64_t end, ExrHeader& header) {
        while (at_ < end && !text().empty()) {
            if (++header.channels > max_channels) refuse(fmt::format("at most {} channels", max_channels), "more");
            header.pixel_bytes += number<std::uint32_t>() == 1 ? 2 : 4;
            skip(12);
        }
    }

    // Every chunk has an offset of eight bytes in the file.
    void check_chunks(const ExrHeader& header) const {
        if (header.width < 1 || header.height < 1) refuse("a picture of at least one pixel", "an empty one");
        const auto pieces = [](std::int64_t whole, std::int64_t part) { return (whole + part - 1) / part; };
        auto chunks = static_cast<double>(pieces(header.height, header.chunk_lines));
        if (header.tile_width > 0 && header.tile_height > 0)
            chunks = static_cast<double>(pieces(header.width, header.tile_width)) *
                     static_cast<double>(pieces(header.height, header.tile_height));
        if (8 * chunks > static_cast<double>(size_))
            refuse(fmt::format("at most {} chunks in {} bytes", size_ / 8, size_), fmt::format("{}", chunks));
    }

    bool ends_here() { return file_.peek() == 0; }

    std::int64_t left() const { return size_ - at_; }

    std::string text() {
        std::string read;
        for (char c = number<char>(); c != '\0'; c = number<char>()) {
            if (read.size() == longest_name)
                refuse(fmt::format("a name of at most {} bytes", longest_name), "a longer one");
            read += c;
        }
        return read;
    }

    template <Number T>
    T number() {
        std::string bytes(sizeof(T), '\0');
        if (left() < std::ssize(bytes) || !file_.read(bytes.data(), std::ssize(bytes)))
            refuse("more of the header", "the end of the file");
        at_ += std::ssize(bytes);
        return number_at<T>(bytes, 0, std::endian::little);
    }

    void skip(std::int64_t bytes) { go_to(at_ + bytes); }
    void go_to(std::int64_t place) {
        if (place > size_) refuse("more of the header", "the end of the file");
        at_ = place;
        file_.seekg(place);
    }

    [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
        throw Error({name_, 0, fmt::format("byte {}", at_)}, expected, found);
    }

    std::string name_;
    std::ifstream file_;
    std::int64_t size_;
    std::int64_t at_ = 0;
    std::size_t attributes_ = 0;
};

}  // namespace

ExrHeader read_exr_header(const std::filesystem::path& path) { return HeaderReader(path).read(); }

}  // namespace raylab

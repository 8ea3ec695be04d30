#include "raylab/scene/mesh/ply_values.h"

#include <cassert>

namespace raylab {

namespace {

[[noreturn]] void refuse_length(const Place& place, std::size_t largest, std::int64_t found) {
    throw Error(place, "a list of at most " + std::to_string(largest) + " items (what is left)", std::to_string(found));
}

}  // namespace

std::size_t PlyText::begin(const PlyElement& element) {
    element_ = element.name;
    // Each value takes a character and a blank or the line's end, which may be missing after the last one.
    return (lines_.bytes_left() + 1) / (2 * element.properties.size());
}

void PlyText::begin_row(std::size_t row) {
    if (!lines_.next()) throw Error(place(), element_ + " " + std::to_string(row), "the end of the file");
    word_ = 0;
}

std::size_t PlyText::next_word() {
    if (word_ >= lines_.words().size())
        throw Error(place(), "more values on the line", std::to_string(lines_.words().size()));
    return word_++;
}

std::size_t PlyText::length(PlyType, PlyType) {
    const auto length = lines_.integer(next_word());
    const auto left = lines_.words().size() - word_;
    if (length < 0 || static_cast<std::uint64_t>(length) > left) refuse_length(place(), left, length);
    return static_cast<std::size_t>(length);
}

void PlyText::end_row() {
    if (word_ < lines_.words().size()) lines_.refuse("the end of the line", word_);
    if (word_ > lines_.words().size())
        throw Error(place(), std::to_string(word_) + " values on the line", std::to_string(lines_.words().size()));
}

std::size_t PlyBytes::begin(const PlyElement& element) {
    element_ = element.name;
    row_ = 0;
    return (bytes_.size() - next_) / element.min_bytes_binary();
}

Place PlyBytes::place() const {
    return {file_, 0, "byte " + std::to_string(next_) + " (" + element_ + " " + std::to_string(row_) + ")"};
}

void PlyBytes::expect(std::size_t bytes) const {
    const auto left = bytes_.size() - next_;
    if (bytes > left) throw Error(place(), std::to_string(bytes) + " more bytes", std::to_string(left));
}

template <class To>
To PlyBytes::take(PlyType type) {
    expect(size_of(type));
    const auto at = next_;
    next_ += size_of(type);
    switch (type) {
        case PlyType::int8:
            return static_cast<To>(number_at<std::int8_t>(bytes_, at, order_));
        case PlyType::uint8:
            return static_cast<To>(number_at<std::uint8_t>(bytes_, at, order_));
        case PlyType::int16:
            return static_cast<To>(number_at<std::int16_t>(bytes_, at, order_));
        case PlyType::uint16:
            return static_cast<To>(number_at<std::uint16_t>(bytes_, at, order_));
        case PlyType::int32:
            return static_cast<To>(number_at<std::int32_t>(bytes_, at, order_));
        case PlyType::uint32:
            return static_cast<To>(number_at<std::uint32_t>(bytes_, at, order_));
        case PlyType::float32:
            return static_cast<To>(number_at<float>(bytes_, at, order_));
        case PlyType::float64:
            return static_cast<To>(number_at<double>(bytes_, at, order_));
    }
    assert(false);
    return {};
}

float PlyBytes::number(PlyType type) {
    return cast<float>(take<double>(type));  // a double holds every type exactly, so there is only one rounding
}

std::int64_t PlyBytes::integer(PlyType type) {
    assert(type < PlyType::float32);
    return take<std::int64_t>(type);
}

std::size_t PlyBytes::length(PlyType count, PlyType item) {
    const auto length = integer(count);
    const auto largest = (bytes_.size() - next_) / size_of(item);
    if (length < 0 || static_cast<std::uint64_t>(length) > largest) refuse_length(place(), largest, length);
    return static_cast<std::size_t>(length);
}

void PlyBytes::skip(PlyType type, std::size_t count) {
    const auto bytes = size_of(type) * count;
    expect(bytes);
    next_ += bytes;
}

void PlyBytes::end() {
    if (next_ < bytes_.size())
        throw Error(place(), "the end of the file", std::to_string(bytes_.size() - next_) + " more bytes");
}

}  // namespace raylab

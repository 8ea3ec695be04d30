#pragma once

#include "raylab/base/bytes.h"
#include "raylab/base/error.h"
#include "raylab/scene/mesh/ply_header.h"

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

// The body of a PLY file, value after value, from text or from bytes. Each reader throws an Error where a value is
// missing or does not fit.

namespace raylab {

template <class V>
concept PlyValues = requires(V values, const V& same, const PlyElement& element, PlyType type, std::size_t n) {
    // The largest number of rows for which the rest of the file has room.
    { values.begin(element) } -> std::same_as<std::size_t>;
    values.begin_row(n);
    { values.number(type) } -> std::same_as<float>;
    { values.integer(type) } -> std::same_as<std::int64_t>;
    { values.length(type, type) } -> std::same_as<std::size_t>;  // of a list whose items are sure to be there
    values.skip(type, n);
    values.end_row();
    values.end();
    { same.place() } -> std::same_as<Place>;
};

/// The values of a text file, which has one row on each line.
class PlyText {
public:
    explicit PlyText(TextLines lines) : lines_(std::move(lines)) {}

    std::size_t begin(const PlyElement& element);
    void begin_row(std::size_t row);
    float number(PlyType) { return lines_.number(next_word()); }
    std::int64_t integer(PlyType) { return lines_.integer(next_word()); }
    std::size_t length(PlyType count, PlyType item);
    void skip(PlyType, std::size_t count) { word_ += count; }
    void end_row();
    void end() { lines_.expect_end(); }
    Place place() const { return lines_.place(); }

private:
    std::size_t next_word();

    TextLines lines_;
    std::string element_ = {};
    std::size_t word_ = 0;
};

class PlyBytes {
public:
    PlyBytes(std::string_view bytes, std::size_t begin, std::endian order, std::string file)
        : bytes_(bytes), next_(begin), order_(order), file_(std::move(file)) {}

    std::size_t begin(const PlyElement& element);
    void begin_row(std::size_t row) { row_ = row; }
    float number(PlyType type);
    std::int64_t integer(PlyType type);
    std::size_t length(PlyType count, PlyType item);
    void skip(PlyType type, std::size_t count);
    void end_row() {}
    void end();
    Place place() const;

private:
    template <class To>
    To take(PlyType type);
    void expect(std::size_t bytes) const;

    std::string_view bytes_;
    std::size_t next_;
    std::endian order_;
    std::string file_;
    std::string element_ = {};
    std::size_t row_ = 0;
};

}  // namespace raylab

#pragma once

#include "raylab/scene/mesh/text_lines.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// The header of a PLY file: which elements follow, and how each of their rows is laid out.

namespace raylab {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The bytes of one value in a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;                       // of the number, or of each item of the list
    std::optional<PlyType> count = {};  // of the number of items; absent where it is not a list
};

struct PlyElement {
    std::string name;
    std::int64_t count;  // as the file says, not yet checked
    std::vector<PlyProperty> properties;

    /// The smallest size of a row, with every list empty.
    std::size_t min_bytes_binary() const;
};

enum class PlyEncoding { text, little_endian, big_endian };

struct PlyHeader {
    PlyEncoding encoding;
    std::vector<PlyElement> elements;
};

/// Reads the header from "ply" to "end_header".
PlyHeader read_ply_header(TextLines& lines);

}  // namespace raylab

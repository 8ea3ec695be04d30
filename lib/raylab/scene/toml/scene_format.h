#pragma once

#include "raylab/scene/toml/format.h"

#include <string>
#include <vector>

// The format of scene files, version 1: every key, what it may hold, its unit and its meaning where it is absent.

namespace raylab::toml_file {

/// A scene file.
const Format& scene_format();

/// A [[shape]], in a scene or a group.
Format shape_format();

/// [{ rotate = { axis = [0, 1, 0], degrees = 30 } }, { translate = [1, 0, 0] }], applied in order.
Format transform_format();
Key transform_end();

// Functions in which the tables are written.

Key required(std::string name, Format format, std::string about);
Key optional(std::string name, Format format, std::string about);
Key otherwise(std::string name, Format format, Value fallback, std::string about);

Format number();
Format coordinate();  // a number that fits a float
Format size();        // above 0, fits a float
Format at_least_zero();
Format from_zero_to_one();
Format vector();         // three numbers that fit floats
Format light_color();    // three numbers, not negative
Format surface_color();  // three numbers from 0 to 1
Format list_of(Format element, std::size_t smallest = 0);
Format array_of(std::size_t count, Format element);

/// One table of a Tagged format; its own tag is among its keys.
Tagged::Alternative alternative(const std::string& tag, const std::string& word, const std::string& what,
                                std::vector<Key> keys);

}  // namespace raylab::toml_file

#include "raylab/scene/toml/scene_format.h"

#include <memory>
#include <utility>

namespace raylab::toml_file {

Key required(std::string name, Format format, std::string about) {
    return {std::move(name), std::move(format), std::move(about)};
}

Key optional(std::string name, Format format, std::string about) {
    return {std::move(name), std::move(format), std::move(about), Presence::optional};
}

Key otherwise(std::string name, Format format, Value fallback, std::string about) {
    return {std::move(name), std::move(format), std::move(about), Presence::optional, std::move(fallback)};
}

Format number() { return {Number{}}; }
Format coordinate() { return {Number{.stored = Stored::as_float}}; }
Format size() { return {Number{.above = 0, .stored = Stored::as_float}}; }
Format at_least_zero() { return {Number{.at_least = 0}}; }
Format from_zero_to_one() { return {Number{.at_least = 0, .at_most = 1}}; }
Format vector() { return array_of(3, coordinate()); }
Format light_color() { return array_of(3, at_least_zero()); }
Format surface_color() { return array_of(3, from_zero_to_one()); }

Format list_of(Format element, std::size_t smallest) {
    return {List{.element = std::make_shared<Format>(std::move(element)), .smallest = smallest}};
}

Format array_of(std::size_t count, Format element) {
    return {List{.element = std::make_shared<Format>(std::move(element)), .smallest = count, .largest = count}};
}

Tagged::Alternative alternative(const std::string& tag, const std::string& word, const std::string& what,
                                std::vector<Key> keys) {
    keys.insert(keys.begin(), optional(tag, {Word{{word}}}, "which kind of table this is"));
    return {.word = word, .table = {.what = what, .keys = std::move(keys)}};
}

}  // namespace raylab::toml_file

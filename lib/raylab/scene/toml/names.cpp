#include "raylab/scene/toml/names.h"

#include "raylab/base/nearest_name.h"

#include <fmt/format.h>

namespace raylab::toml_file {

std::size_t Names::add(const std::string& name, const Place& place) {
    const auto [entry, is_new] = indices_.try_emplace(name, indices_.size());
    if (!is_new)
        throw Error(place, fmt::format("each {} to be defined once", what_),
                    fmt::format("\"{}\" again (first at {})", name, to_string(places_[entry->second])));
    places_.push_back(place);
    return entry->second;
}

std::size_t Names::find(const std::string& name, const Place& place) const {
    const auto entry = indices_.find(name);
    if (entry != indices_.end()) return entry->second;
    std::vector<std::string> known;
    for (const auto& [each, index] : indices_) known.push_back(each);
    throw Error(place, fmt::format("the name of a {}", what_), with_suggestion(name, known));
}

}  // namespace raylab::toml_file

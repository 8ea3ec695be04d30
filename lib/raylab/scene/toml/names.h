#pragma once

#include "raylab/base/error.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace raylab::toml_file {

/// The names that an author gave to materials or groups, in the order of definition.
class Names {
public:
    explicit Names(std::string what) : what_(std::move(what)) {}  // "material"

    /// Adds a name and returns its index; throws an Error for a name that is taken.
    std::size_t add(const std::string& name, const Place& place);

    /// The index of a name; throws an Error, with the nearest known name, for an unknown one.
    std::size_t find(const std::string& name, const Place& place) const;

    std::size_t size() const { return indices_.size(); }

private:
    std::string what_;
    std::map<std::string, std::size_t> indices_;
    std::vector<Place> places_;
};

}  // namespace raylab::toml_file

#pragma once

#include "raylab/radiosity/mesh/patch.h"

#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace raylab {

/// Vertices of one smooth group and side that stand at one place are one. Places are compared as floats: two facets
/// compute a shared corner by different sums.
class SharedVertices {
public:
    explicit SharedVertices(std::vector<Vec3d>& vertices) : vertices_(vertices) {}

    std::uint32_t number(std::uint32_t group, FacetSide side, const Vec3d& at) {
        const auto [found, is_new] =
            numbers_.try_emplace(key(group, side, at), static_cast<std::uint32_t>(vertices_.size()));
        if (is_new) vertices_.push_back(at);
        return found->second;
    }

    std::optional<std::uint32_t> find(std::uint32_t group, FacetSide side, const Vec3d& at) const {
        const auto found = numbers_.find(key(group, side, at));
        return found == numbers_.end() ? std::nullopt : std::optional(found->second);
    }

private:
    using Key = std::tuple<std::uint32_t, FacetSide, float, float, float>;

    static Key key(std::uint32_t group, FacetSide side, const Vec3d& at) {
        const auto rounded = [](double x) { return static_cast<float>(x) + 0.0f; };  // no negative zero
        return {group, side, rounded(at.x), rounded(at.y), rounded(at.z)};
    }

    std::vector<Vec3d>& vertices_;
    std::map<Key, std::uint32_t> numbers_;
};

}  // namespace raylab

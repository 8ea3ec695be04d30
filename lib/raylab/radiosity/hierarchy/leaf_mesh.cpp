#include "raylab/radiosity/hierarchy/leaf_mesh.h"

#include "raylab/radiosity/mesh/quartered_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace raylab {

LeafMesh leaf_mesh(PatchMesh roots, const ElementTree& elements) {
    std::vector<std::uint32_t> of_patches(elements.roots());
    std::iota(of_patches.begin(), of_patches.end(), 0);
    const auto has_quarters = [&](std::uint32_t element) { return !elements[element].is_leaf(); };
    while (std::ranges::any_of(of_patches, has_quarters)) {
        std::vector<bool> chosen;
        std::vector<std::uint32_t> next;
        for (const std::uint32_t element : of_patches) {
            chosen.push_back(has_quarters(element));
            if (!chosen.back())
                next.push_back(element);
            else
                for (std::uint32_t i = 0; i < 4; ++i) next.push_back(elements[element].first_child + i);
        }
        roots = quartered_mesh(std::move(roots), chosen);
        of_patches = std::move(next);
    }
    return {std::move(roots), std::move(of_patches)};
}

}  // namespace raylab

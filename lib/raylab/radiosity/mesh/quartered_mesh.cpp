#include "raylab/radiosity/mesh/quartered_mesh.h"

#include "raylab/radiosity/mesh/shared_vertices.h"

#include <algorithm>
#include <utility>

namespace raylab {

namespace {

/// The vertices on sides of patches, those of coarse patches before those of finer ones.
class HangingVertices {
public:
    HangingVertices(const PatchMesh& mesh, const SharedVertices& shared) : mesh_(mesh), shared_(shared) {
        for (const Patch& patch : mesh.patches)
            for (std::uint32_t i = 0; i < patch.corner_count; ++i)
                add_between(patch, patch.level, patch.vertices[i], patch.vertices[(i + 1) % patch.corner_count]);
        std::ranges::stable_sort(found_, {}, &AtLevel::level);
    }

    std::vector<HangingVertex> in_order() const {
        std::vector<HangingVertex> result;
        for (const AtLevel& one : found_) result.push_back(one.hanging);
        return result;
    }

private:
    struct AtLevel {
        int level;
        HangingVertex hanging;
    };

    // What lies between the ends of a side: the middle, and the middles of both halves. The middle's level is one more
    // than the patch's, so its ends have lower ones.
    void add_between(const Patch& patch, int level, std::uint32_t a, std::uint32_t b) {
        const auto middle = shared_.find(mesh_.model.facets[patch.facet].smooth, patch.side,
                                         0.5 * (mesh_.vertices[a] + mesh_.vertices[b]));
        if (!middle || *middle == a || *middle == b) return;
        found_.push_back({level + 1, {*middle, {a, b}}});
        add_between(patch, level + 1, a, *middle);
        add_between(patch, level + 1, *middle, b);
    }

    const PatchMesh& mesh_;
    const SharedVertices& shared_;
    std::vector<AtLevel> found_ = {};
};

void number_vertices(PatchMesh& mesh) {
    mesh.vertices.clear();
    SharedVertices shared(mesh.vertices);
    for (Patch& patch : mesh.patches)
        for (std::uint32_t i = 0; i < patch.corner_count; ++i)
            patch.vertices[i] = shared.number(mesh.model.facets[patch.facet].smooth, patch.side, patch.corners[i]);
    mesh.hanging = HangingVertices(mesh, shared).in_order();
}

}  // namespace

PatchMesh quartered_mesh(PatchMesh mesh, const std::vector<bool>& chosen) {
    const std::vector<Patch> before = std::move(mesh.patches);
    mesh.patches.clear();
    std::vector<std::uint32_t> first;  // of the patches that stand for each
    for (std::size_t i = 0; i < before.size(); ++i) {
        first.push_back(static_cast<std::uint32_t>(mesh.patches.size()));
        if (chosen[i])
            for (const Patch& quarter : quarters(before[i])) mesh.patches.push_back(quarter);
        else
            mesh.patches.push_back(before[i]);
    }
    const std::size_t cells = mesh.cells.size();
    for (std::size_t i = 0; i < cells; ++i) {
        if (mesh.cells[i].kind != PatchCell::Kind::patch) continue;
        const std::uint32_t patch = mesh.cells[i].number;
        mesh.cells[i].number = first[patch];
        if (!chosen[patch]) continue;
        mesh.cells[i] = {PatchCell::Kind::quartered, static_cast<std::uint32_t>(mesh.cells.size())};
        for (std::uint32_t quarter = 0; quarter < 4; ++quarter)
            mesh.cells.push_back({PatchCell::Kind::patch, first[patch] + quarter});
    }
    number_vertices(mesh);
    return mesh;
}

}  // namespace raylab

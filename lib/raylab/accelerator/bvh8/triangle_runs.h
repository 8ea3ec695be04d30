#pragma once

#include "raylab/geometry/shapes.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace raylab {

/// The triangles from which a tree is built, numbered in the order in which they were added, with their sides, which
/// are both or the front. Those of large meshes are read where they stand, because a copy takes 36 bytes a triangle,
/// about as much as the tree: such a mesh must outlive the runs.
class TriangleRuns {
public:
    TriangleRuns() = default;
    TriangleRuns(std::vector<Triangle> triangles) : size_(triangles.size()), copies_(std::move(triangles)) {
        runs_.push_back({0, nullptr, 0, Sides::both});
    }

    void add(const Triangle& triangle, Sides sides = Sides::both) {
        if (runs_.empty() || runs_.back().mesh || runs_.back().sides != sides)
            runs_.push_back({size_, nullptr, copies_.size(), sides});
        copies_.push_back(triangle);
        ++size_;
    }
    void add(const Mesh& mesh, Sides sides = Sides::both) {
        if (mesh.faces.size() < fewest_in_place) {
            for (std::size_t face = 0; face < mesh.faces.size(); ++face) add(mesh.triangle(face), sides);
            return;
        }
        runs_.push_back({size_, &mesh, 0, sides});
        size_ += mesh.faces.size();
    }

    std::size_t size() const { return size_; }

    Triangle operator[](std::size_t number) const {
        const Run& run = run_of(number);
        return run.mesh ? run.mesh->triangle(number - run.first) : copies_[run.first_copy + number - run.first];
    }

    Sides sides(std::size_t number) const { return run_of(number).sides; }

    // The triangles of a leaf are scattered in memory. First what names a triangle's corners is prefetched, then the
    // corners.
    void prefetch_names(std::size_t number) const {
        const Run& run = run_of(number);
        if (run.mesh)
            __builtin_prefetch(&run.mesh->faces[number - run.first]);
        else
            __builtin_prefetch(&copies_[run.first_copy + number - run.first]);
    }
    void prefetch_corners(std::size_t number) const {
        const Run& run = run_of(number);
        if (!run.mesh) return;
        const auto [a, b, c] = run.mesh->faces[number - run.first];
        for (const auto vertex : {a, b, c}) __builtin_prefetch(&run.mesh->vertices[vertex]);
    }

private:
    // The triangles from `first` on: of a mesh, or copies.
    struct Run {
        std::size_t first;
        const Mesh* mesh;
        std::size_t first_copy;
        Sides sides;
    };
    // Smaller meshes are copied, so that there are few runs to search.
    static constexpr std::size_t fewest_in_place = 4096;

    const Run& run_of(std::size_t number) const {
        if (runs_.size() == 1) return runs_[0];
        return *(std::ranges::upper_bound(runs_, number, {}, &Run::first) - 1);
    }

    std::size_t size_ = 0;
    std::vector<Run> runs_;
    std::vector<Triangle> copies_;
};

}  // namespace raylab

#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/radiosity/mesh/patch_mesh.h"

#include <array>
#include <memory>

namespace raylab {

/// Whether points of patches see each other, decided exactly by shadow rays through the default accelerator. What is
/// seen from one side only stops light from either: else i could see j, and j not see i. One for all threads; the
/// Traversal is the caller's.
class PatchVisibility {
public:
    explicit PatchVisibility(const PatchMesh& mesh);

    /// True if nothing stands between a point of patch `from` and a point of patch `to`. The two patches' own planes
    /// hide nothing: their points lie on them but for rounding.
    bool sees(std::uint32_t from, const Vec3d& start, std::uint32_t to, const Vec3d& end, Traversal& traversal) const;

    /// The same towards a point that lies on no patch, such as a light.
    bool sees_point(std::uint32_t from, const Vec3d& start, const Vec3d& end, Traversal& traversal) const;

    /// The same towards infinity.
    bool sees_direction(std::uint32_t from, const Vec3d& start, const Vec3d& direction, Traversal& traversal) const;

    /// The share of `rays` pairs of points, spread evenly over two patches, that see each other. The points are the
    /// same in every run; rays = 0 asks nothing, and the answer is 1.
    double share(std::uint32_t a, std::uint32_t b, int rays, Traversal& traversal) const;

    /// The same for parts of patches `a` and `b`. `shifts` move the pairs of points.
    struct Part {
        std::uint32_t of;
        const Patch& patch;
    };
    double share(const Part& a, const Part& b, int rays, const std::array<double, 4>& shifts,
                 Traversal& traversal) const;

    /// The share of what a part of a patch sends out that meets a patch or leaves the scene, by `rays` rays. The rest
    /// ends on sides without patches: the floor under a box without a bottom sees the box from inside.
    double share_with_patches(const Part& part, int rays, Traversal& traversal) const;

private:
    bool is_open(const Ray& ray, std::uint32_t from, const std::uint32_t* to, Traversal& traversal) const;

    const PatchMesh& mesh_;
    Scene occluders_;  // the mesh's polygons, seen from both sides
    std::unique_ptr<Accelerator> accelerator_;
};

/// Numbers in [0, 1), the same in every run, that belong to a pair.
std::array<double, 4> shifts_of_pair(std::uint64_t a, std::uint64_t b);

/// A point of a patch for two numbers in [0, 1): as evenly spread as they are, on a parallelogram or a triangle.
Vec3d point_of(const Patch& patch, double u, double v);

}  // namespace raylab

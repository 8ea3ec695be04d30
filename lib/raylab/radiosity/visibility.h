#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/radiosity/mesh/patch_mesh.h"

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

private:
    bool is_open(const Ray& ray, std::uint32_t from, const std::uint32_t* to, Traversal& traversal) const;

    const PatchMesh& mesh_;
    Scene occluders_;  // the mesh's polygons, seen from both sides
    std::unique_ptr<Accelerator> accelerator_;
};

/// A point of a patch for two numbers in [0, 1): as evenly spread as they are, on a parallelogram or a triangle.
Vec3d point_of(const Patch& patch, double u, double v);

}  // namespace raylab

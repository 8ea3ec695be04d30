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

    /// True in a convex room: every polygon has the whole scene on one side of it, so no ray between two points of the
    /// scene is stopped, and none need be cast. Asked of scenes of at most 1000 polygons.
    bool nothing_hides() const { return nothing_hides_; }

    /// True if nothing stands between a point of patch `from` and a point of patch `to`. The two patches' own planes
    /// hide nothing: their points lie on them but for rounding.
    bool sees(std::uint32_t from, const Vec3d& start, std::uint32_t to, const Vec3d& end, Traversal& traversal) const;

    /// The same towards a point that lies on no patch, such as a light.
    bool sees_point(std::uint32_t from, const Vec3d& start, const Vec3d& end, Traversal& traversal) const;

    /// The same towards infinity.
    bool sees_direction(std::uint32_t from, const Vec3d& start, const Vec3d& direction, Traversal& traversal) const;

    /// How much of the light between two patches passes.
    struct OpenShare {
        double share;  // 0 to 1
        double rays;   // so many rays of equal weight would scatter as much
    };

    /// By `rays` shadow rays between pairs of points, spread evenly over both. Each counts by what its two points would
    /// exchange, cos cos / r^2: near points exchange most and are hidden least, and rays that all counted alike made
    /// the Cornell box 5 % too dark with 240 patches. Points that are turned away from each other are left out. The
    /// points are the same in every run; rays = 0 asks nothing, and the share is 1.
    OpenShare share(std::uint32_t a, std::uint32_t b, int rays, Traversal& traversal) const;

    /// The same for parts of patches `a` and `b`. `shifts` move the pairs of points.
    struct Part {
        std::uint32_t of;
        const Patch& patch;
    };
    OpenShare share(const Part& a, const Part& b, int rays, const std::array<double, 4>& shifts,
                    Traversal& traversal) const;

    /// What a part of a patch sees, by `rays` rays.
    struct Surroundings {
        double with_patches;  // the share of its view that is a patch, or lies outside of the scene. The rest is sides
                              // without patches: the floor under a box without a bottom sees the box from inside
        Vec3d background{0, 0, 0};  // the mean radiance of what it sees outside
    };
    Surroundings surroundings(const Part& part, int rays, Traversal& traversal) const;

    /// The same from one point of a patch.
    Surroundings surroundings(std::uint32_t of, const Vec3d& point, int rays, Traversal& traversal) const;

private:
    template <class PointAt>
    Surroundings seen_around(std::uint32_t of, const Vec3d& normal, int rays, const PointAt& point_at,
                             Traversal& traversal) const;
    bool is_open(const Ray& ray, std::uint32_t from, const std::uint32_t* to, Traversal& traversal) const;

    const PatchMesh& mesh_;
    Scene occluders_;  // the mesh's polygons, seen from both sides
    std::unique_ptr<Accelerator> accelerator_;
    bool nothing_hides_;
};

/// Numbers in [0, 1), the same in every run, that belong to a pair.
std::array<double, 4> shifts_of_pair(std::uint64_t a, std::uint64_t b);

/// A point of a patch for two numbers in [0, 1): as evenly spread as they are, on a parallelogram or a triangle.
Vec3d point_of(const Patch& patch, double u, double v);

}  // namespace raylab

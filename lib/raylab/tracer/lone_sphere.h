#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/plain_sphere.h"

namespace raylab {

/// What rays meet where there is one plain sphere. The answers are a list's, the same bits, and so are the counts.
class LoneSphere {
public:
    /// Whether a scene of plain spheres is one: a single one, seen from both sides, and no speck beside its coordinates.
    static bool suits(const Scene& scene);

    LoneSphere(const Scene& scene, const Accelerator&, const Lighting& lighting) : sphere_(scene, 0, lighting) {}

    using Memory = TestCounts;

    struct Met {
        double t;
        Vec3d near;  // where the ray is at t
        sphere_filter::Way way;
    };

    std::optional<Met> closest(const Ray& ray, TestCounts& counts) const {
        Vec3d origin = convert<double>(ray.origin), direction = convert<double>(ray.direction);
        auto verdict = sphere_filter::decide(origin, direction, ray.range, sphere_.ball, Sides::both);
        using What = sphere_filter::Verdict::What;
        ++counts.primitive_tests;
        if (verdict.what == What::missed) return std::nullopt;
        if (verdict.what == What::undecided) [[unlikely]] {
            // Of numbers, which stay in registers until then; what a function is shown does not.
            Settled settled = settle({origin, direction, {ray.range.min, ray.range.max}});
            counts.exact_decisions += settled.exact;
            return settled.met;
        }
        return Met{verdict.at.t, origin + verdict.at.t * direction, verdict.way};
    }

    const PlainSphere& sphere(const Met&) const { return sphere_; }

    /// Whether the ray, in this direction, comes to the outside. Others ask it of the normal; the root tells the same of what
    /// suits(), where doubles tell the root:
    //
    // With the names of sphere_filter::decide() and F = max(r, |f|), its bound on q leaves the product of direction and normal,
    // sqrt(discriminant / a) / r, at least 13 2^-27 F / r. The error of t moves the hit along the ray by 4 2^-27 F at most, the
    // rounding of coordinates by less than 2^-27 F: neither turns the product's sign.
    static bool is_outside(const Met& hit, const SurfacePoint&, const Vec3d&) { return hit.way == sphere_filter::Way::in; }

private:
    // Where doubles cannot tell.
    struct Settled {
        std::optional<Met> met;
        std::uint64_t exact;
    };
    [[gnu::cold, gnu::noinline]] Settled settle(RayOf<double> ray) const;

    PlainSphere sphere_;
};

}  // namespace raylab

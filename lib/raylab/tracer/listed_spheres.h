#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/geometry/sphere_filter.h"
#include "raylab/geometry/sphere_position.h"
#include "raylab/tracer/surface_point.h"

#include <vector>

namespace raylab {

/// What rays meet in a scene of nothing but spheres at rest where they were made, found by a list: one alone is not asked what
/// it is. The answers are the list's, the same bits, and so are the counts.
class ListedSpheres {
    struct Listed {
        Sides sides;
        sphere_filter::Ball ball;
        SpherePosition surface;
        const Object* object;
        Primitive primitive;
    };

public:
    static constexpr bool may_be_smooth = false;

    ListedSpheres(const Scene& scene, const Accelerator& list);
    ListedSpheres(const ListedSpheres&) = delete;
    ListedSpheres& operator=(const ListedSpheres&) = delete;

    struct Met {
        double t;
        const Listed* sphere;
        Vec3d near;  // where the ray is at t
    };

    std::optional<Met> closest(const Ray& ray, Traversal& traversal) const {
        if (count_ != 1) [[unlikely]] return closest_of_several(ray, traversal);
        const Listed& only = *first_;
        Vec3d origin = convert<double>(ray.origin), direction = convert<double>(ray.direction);
        using What = sphere_filter::Verdict::What;
        auto verdict = sphere_filter::decide(origin, direction, ray.range, only.ball, only.sides);
        if (verdict.what == What::undecided) [[unlikely]] return closest_of_several(ray, traversal);
        ++traversal.primitive_tests;
        if (verdict.what == What::missed) return std::nullopt;
        return Met{verdict.at.t, &only, origin + verdict.at.t * direction};
    }

    SurfacePoint point(const Ray&, const Met& hit) const {
        const Listed& sphere = *hit.sphere;
        auto [position, error, normal] = sphere.surface.at(hit.near);
        return {.position = position,
                .error = error,
                .normal = normal,
                .shading_normal = normal,
                .object = sphere.object,
                .primitive = sphere.primitive};
    }

private:
    // Of two spheres or more, and where doubles cannot tell: the list's answer.
    std::optional<Met> closest_of_several(const Ray& ray, Traversal& traversal) const;

    const Accelerator& list_;
    std::vector<Listed> spheres_;  // one or more
    std::uint64_t count_;          // of them, and the first: a ray has no time to ask the vector
    const Listed* first_;
};

}  // namespace raylab

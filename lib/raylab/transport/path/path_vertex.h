#pragma once

#include "raylab/geometry/local_frame.h"
#include "raylab/tracer/phong_specular.h"
#include "raylab/tracer/shading/shading_point.h"
#include "raylab/transport/lobe/material_lobes.h"
#include "raylab/transport/path/lobe_choice.h"
#include "raylab/transport/path/transport_options.h"
#include "raylab/transport/power_heuristic.h"

namespace raylab {

/// What is known where a path meets a surface, and how much light its lobes scatter there. Directions are given twice:
/// in the world, and as `wi` in the frame.
template <class Lobes>
struct PathVertex {
    const ShadingPoint& here;
    LocalFrame frame;  // z is the shading normal on the ray's side
    Vec3d wo;          // to where the path comes from, in the frame
    Interface interface;
    Lobes lobes;
    LobeChoice choice = {};

    /// What all spread lobes scatter to wo.
    Color scattered(const Vec3d& direction, const Vec3d& wi) const {
        Color sum(0);
        if (scatters_to(direction, wi))
            for (const auto& lobe : lobes.spread) sum += value(lobe, wo, wi);
        return sum;
    }

    /// The same of a direction to a point on a light that was chosen with this density: each lobe times the share that
    /// such points have of it, beside a path that goes on along that lobe.
    Color weighted(const Vec3d& direction, const Vec3d& wi, double light_density, LightStrategy strategy) const {
        if (!scatters_to(direction, wi)) return Color(0);
        const double by_lobes = strategy == LightStrategy::lights ? 0 : density(lobes, choice, wo, wi);
        const double share = strategy == LightStrategy::lobes ? 0 : power_heuristic(light_density, by_lobes);
        Color sum(0);
        for (std::size_t i = 0; i < lobes.spread.size(); ++i)
            sum += (choice.chances[i] > 0 ? share : 1) * value(lobes.spread[i], wo, wi);
        return sum;
    }

    /// What the lobes scatter that may be followed. All of them bring the light of a direction that one of them chose:
    /// the less they differ, the less noise.
    Color followed(const Vec3d& wi) const {
        Color sum(0);
        for (std::size_t i = 0; i < lobes.spread.size(); ++i)
            if (choice.chances[i] > 0) sum += value(lobes.spread[i], wo, wi);
        return sum;
    }

    /// Whitted's highlight, which no energy is kept for.
    Color highlight(const Vec3d& to_light) const {
        const Finish& m = here.material;
        const bool is_in_front = dot(here.normal, to_light) > 0 && dot(frame.z, to_light) > 0;
        if (!is_in_front || m.specular == Color(0)) return Color(0);
        return m.specular * phong_specular(frame.z, to_light, -here.direction, m.shininess);
    }

    /// Whether a direction lies on the same side of the surface as of its shading normal's plane.
    bool scatters_to(const Vec3d& direction, const Vec3d& wi) const {
        return (dot(here.normal, direction) > 0) == (wi.z > 0);
    }
};

}  // namespace raylab

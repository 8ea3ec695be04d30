#pragma once

#include "raylab/scene/pigment.h"
#include "raylab/tracer/picture/models.h"
#include "raylab/tracer/shading/shading_point.h"
#include "raylab/tracer/whitted/ray_observers.h"

#include <optional>

namespace raylab {

/// I_local of Whitted's recursion (whitted_tracer.h): the light that a point sends out by itself and by what comes
/// straight from the lights.
template <class Observer, class Model>
class LocalLight {
public:
    using Node = typename Observer::Node;
    using Surfaces = typename Model::Surfaces;

    LocalLight(const Scene& scene, const Surfaces& surfaces, const Lighting& lighting, const WhittedOptions& options,
               Traversal& traversal, Observer observer)
        : scene_(scene),
          surfaces_(surfaces),
          lighting_(lighting),
          options_(options),
          casts_shadows_(Model::shadow_rays && options.shadows == WhittedOptions::Shadows::cast),
          traversal_(traversal),
          observer_(observer) {
        if (casts_shadows_ && !lighting.lights.empty())
            traversal.toward(lighting.lights.size() - 1);  // makes room for all
    }

    /// Emission, the ambient light's share, and Phong's two terms of every light that is seen. Inlined: 0.8 % of
    /// the picture of tests/bench/mirror_and_glass.toml.
    [[gnu::always_inline]] Color operator()(const ShadingPoint& here, Node node) {
        if (!here.front && options_.lit == WhittedOptions::Lit::outer_side) return color_outside(here, node);
        return color(here, node);
    }

private:
    [[gnu::noinline]] Color color_outside(const ShadingPoint& here, Node node) {
        return color(from_outside(here), node);
    }

    // I_local = I_unlit + sum over the lights that are seen of I_light (k_diffuse N.L + k_specular cos^n(R, V)).
    [[gnu::always_inline]] Color color(const ShadingPoint& here, Node node) {
        Color sum = here.material.unlit;
        if (lighting_.lights.empty()) return sum;
        const Shading shading = is_smooth(*here.at.object) ? here.at.object->shading : Shading::flat;
        const Color diffuse = color_at(here.material.diffuse, here.at.position, here.at.normal);
        for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
            const ShadingLight& light = lighting_.lights[i];
            const Bearing toward = bearing(light, here.at.position);
            if (is_turned_away(here, toward.to_light, shading)) continue;
            const std::optional<Color> incident = incident_color(light, toward);
            if (!incident) continue;
            const Ray shadow_ray = casts_shadows() ? ray_to_light(here, toward) : Ray{};
            if (is_shadowed(i, shadow_ray, node)) continue;
            const Color reflected = shading == Shading::gouraud
                                        ? reflected_between_corners(here, light, diffuse)
                                        : reflected_here(here, toward.to_light, *incident, diffuse);
            if (casts_shadows()) observer_.shadow_ray_cast(node, i, shadow_ray, Ending::reached, reflected);
            sum += reflected;
        }
        return sum;
    }

    // Whether a surface is in its own shadow, N.L <= 0. Without shadows a smooth mesh is not: where its dark side
    // begins is left to its vertices' normals, which know nothing of facets.
    bool is_turned_away(const ShadingPoint& here, const Vec3d& to_light, Shading shading) const {
        if (!(dot(here.normal, to_light) > 0) && (shading == Shading::flat || casts_shadows())) return true;
        return shading == Shading::phong && !(dot(here.shading, to_light) > 0);
    }

    bool casts_shadows() const { return Model::shadow_rays && casts_shadows_; }

    Ray ray_to_light(const ShadingPoint& here, const Bearing& toward) const {
        return leaving_here(here, toward.to_light, length_of_shadow_ray(toward.distance), options_.start);
    }

    // Whether something stands between the point and a light.
    bool is_shadowed(std::size_t number, const Ray& shadow_ray, Node node) {
        if (!casts_shadows()) return false;
        traversal_.light = number;
        if (!surfaces_.occluded(shadow_ray, traversal_)) return false;
        observer_.shadow_ray_cast(node, number, shadow_ray, Ending::blocked, {0, 0, 0});
        return true;
    }

    // Phong's two terms.
    Color reflected_here(const ShadingPoint& here, const Vec3d& to_light, const Color& incident,
                         const Color& diffuse) const {
        const LitPoint point{here.at.position, here.shading, to_viewer(here, options_)};
        return reflected_light(dot(here.shading, to_light), to_light, incident, point, diffuse, here.material);
    }

    Color reflected_between_corners(const ShadingPoint& here, const ShadingLight& light, const Color& diffuse) const {
        return between_corners(light, lit_corners(here, scene_.camera, options_), here.at, diffuse, here.material);
    }

    const Scene& scene_;
    const Surfaces& surfaces_;
    const Lighting& lighting_;
    const WhittedOptions& options_;
    const bool casts_shadows_;
    Traversal& traversal_;
    Observer observer_;
};

}  // namespace raylab

#pragma once

#include "raylab/scene/pigment.h"
#include "raylab/tracer/models.h"
#include "raylab/tracer/shading_point.h"
#include "raylab/tracer/ray_observers.h"

#include <optional>

namespace raylab {

/// What a point shows by itself and by light that comes straight from the lamps: I_local. Part of whitted_tracer.h.
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
          casts_shadows_(Model::feelers && options.shadows == WhittedOptions::Shadows::cast),
          traversal_(traversal),
          observer_(observer) {
        if (casts_shadows_ && !lighting.lamps.empty()) traversal.toward(lighting.lamps.size() - 1);  // makes room for all
    }

    /// Emission, the ambient light's share, and Phong's two terms of every light that is seen. Inlined: a call of so much takes
    /// its time, and without feelers all of it fits into the loop over the pixels.
    [[gnu::always_inline]] Color operator()(const ShadingPoint& here, Node node) {
        if (!here.front && options_.lit == WhittedOptions::Lit::outer_side) return color_outside(here, node);
        return color(here, node);
    }

private:
    [[gnu::noinline]] Color color_outside(const ShadingPoint& here, Node node) { return color(from_outside(here), node); }

    [[gnu::always_inline]] Color color(const ShadingPoint& here, Node node) {
        const Finish& material = here.material;
        Color sum = material.unlit;
        if (lighting_.lamps.empty()) return sum;
        const Color* plain = std::get_if<Color>(&material.diffuse);
        Color patterned;
        if (!plain) patterned = color_at(material.diffuse, here.at.position, here.at.normal);
        const Color& diffuse = plain ? *plain : patterned;
        const bool smooth = Surfaces::may_be_smooth && is_smooth(*here.at.object);
        const bool at_corners = smooth && here.at.object->shading == Shading::gouraud;
        std::size_t number = 0;
        for (const Lamp& lamp : lighting_.lamps) {
            const std::size_t i = number++;
            const Bearing light = bearing(lamp, here.at.position);
            // A surface may be in its own light. Without shadows it never is: where the dark side of a mesh begins is left
            // to its smooth normals, which know nothing of facets.
            const double facing = dot(here.normal, light.to_light);
            if (!(facing > 0) && (!smooth || casts_shadows() || !(light.distance > 0))) continue;
            const double cosine = smooth ? dot(here.shading, light.to_light) : facing;
            if (smooth && !at_corners && !(cosine > 0)) continue;
            const Color* arriving = &lamp.color;
            Color less;
            if (lamp.dims) {
                const auto left = dimmed(lamp, light);
                if (!left) continue;
                less = *left;
                arriving = &less;
            }
            const double length = length_of_feeler(light.distance);
            const Ray felt = casts_shadows() ? leaving_here(here, light.to_light, length, options_.start) : Ray{};
            if (casts_shadows() && is_blocked(i, felt, node)) continue;
            const LitPoint point{here.at.position, here.shading, to_viewer(here, options_)};
            Color brought = at_corners ? between_corners(lamp, lit_corners(here, scene_.camera, options_), here.at, diffuse, material)
                                       : reflected_light(cosine, light.to_light, *arriving, point, diffuse, material);
            if (casts_shadows()) observer_.felt(node, i, felt, Ending::reached, brought);
            sum += brought;
        }
        return sum;
    }

    bool casts_shadows() const { return Model::feelers && casts_shadows_; }

    // Whether something is in a light's way.
    bool is_blocked(std::size_t number, const Ray& felt, Node node) {
        if constexpr (Model::feelers) {
            traversal_.light = number;
            if (!surfaces_.occluded(felt, traversal_)) return false;
            observer_.felt(node, number, felt, Ending::blocked, {0, 0, 0});
        }
        return Model::feelers;
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

#pragma once

#include "raylab/scene/pigment.h"
#include "raylab/tracer/lighting.h"
#include "raylab/tracer/media_beside.h"
#include "raylab/tracer/models.h"
#include "raylab/tracer/ray_observers.h"
#include "raylab/tracer/reflected_light.h"
#include "raylab/tracer/whitted.h"

#include <array>
#include <limits>

// Whitted's recursion itself. Programs call whitted.h; here it is a template on who looks on and on the model (models.h).
// What a ray makes on its way is not const: GCC 12 keeps constant aggregates in memory ("store to a read-only decl" in its
// scalar replacement), where others stay in registers.

namespace raylab {

/// Traces eye rays, one after the other.
template <class Observer, class Model>
class WhittedTracer {
public:
    using Node = typename Observer::Node;
    using Surfaces = typename Model::Surfaces;

    WhittedTracer(const Scene& scene, const Surfaces& surfaces, const Lighting& lighting, const WhittedOptions& options,
                  Traversal& traversal, Observer observer)
        : scene_(scene), surfaces_(surfaces), lighting_(lighting), options_(options), traversal_(traversal), observer_(observer) {}

    /// The colour along an eye ray that begins in these media.
    Color operator()(const Ray& eye_ray, const Media& around_eye) {
        if constexpr (Model::recursion) return root_color(eye_ray, around_eye);
        else return color({RayKind::eye, 1, 1}, {}, eye_ray, around_eye);
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    // Not inlined: without recursion, and only there, all that a ray takes fits into the loop over the pixels (fill()).
    [[gnu::noinline]] Color root_color(const Ray& eye_ray, const Media& around_eye) {
        return color({RayKind::eye, 1, 1}, {}, eye_ray, around_eye);
    }

    Color color(const CastRay& cast, Node parent, const Ray& ray, const Media& media) {
        const Node node = observer_.cast(cast, parent, ray);
        auto hit = surfaces_.closest(ray, traversal_);
        if (!hit) return background(node);
        SurfacePoint at = surfaces_.point(ray, *hit);
        observer_.met(node, at, hit->t);
        Place here = place_of(ray, hit->t, at);
        if constexpr (!Model::recursion) return diffuse_color(here, node);
        else return color_from(cast, node, here, media);
    }

    Place place_of(const Ray& ray, double t, const SurfacePoint& at) const {
        Place here = place(lighting_, ray, t, at);
        if constexpr (Model::feelers || Model::recursion) here.beside = detail::beside(at, here.normal);
        return here;
    }

    Color background(Node node) {
        observer_.missed(node, scene_.background.color);
        return scene_.background.color;
    }

    Color color_from(const CastRay& cast, Node node, const Place& here, const Media& media) {
        const Finish& material = here.material;
        if (material.kr == 0 && material.kt == 0) return diffuse_color(here, node);
        if (material.kt == 0) return branched_color(cast, node, here, {.reflected = material.kr}, media, media);
        const Beside beside = media_beside(here, media);
        if (is_hidden(beside)) return color_behind(cast, node, here, beside.behind);
        const Branches branches = branches_at(here, beside.before.ior(scene_), beside.behind.ior(scene_), options_.reflectance);
        return branched_color(cast, node, here, branches, beside.before, beside.behind);
    }

    // Whether a surface lies inside of a stronger medium.
    bool is_hidden(const Beside& beside) const { return beside.before.current(scene_) == beside.behind.current(scene_); }

    // Past surfaces that are hidden: a loop, since they do not count for the depth, and a scene may have a million.
    Color color_behind(CastRay cast, Node node, const Place& hidden, Media media) {
        cast.kind = RayKind::transmitted;
        for (Ray ray = onward(hidden);;) {
            observer_.shaded(node, {0, 0, 0}, Ending::branched);
            node = observer_.cast(cast, node, ray);
            auto hit = surfaces_.closest(ray, traversal_);
            if (!hit) return background(node);
            SurfacePoint at = surfaces_.point(ray, *hit);
            observer_.met(node, at, hit->t);
            Place here = place_of(ray, hit->t, at);
            if (here.material.kt == 0) return color_from(cast, node, here, media);
            const Beside beside = media_beside(here, media);
            if (!is_hidden(beside)) return color_from(cast, node, here, media);
            media = beside.behind;
            ray = onward(here);
        }
    }

    Color diffuse_color(const Place& here, Node node) {
        Color local = local_color(here, node);
        observer_.shaded(node, local, Ending::diffuse);
        return local;
    }

    Color branched_color(const CastRay& cast, Node node, const Place& here, const Branches& branches, const Media& before,
                         const Media& behind) {
        Color local = local_color(here, node);
        observer_.shaded(node, local, Ending::branched);
        Color sum = local;
        if (branches.reflected > 0 || options_.threshold < 0)
            sum += follow(RayKind::reflected, branches.reflected, mirrored(here), cast, node, here, before);
        if (branches.refracted)
            sum += follow(RayKind::transmitted, branches.transmitted, *branches.refracted, cast, node, here, behind);
        else if (here.material.kt > 0)
            observer_.cut({RayKind::transmitted, cast.depth + 1, 0}, node, Ending::total_reflection);
        return sum;
    }

    Color follow(RayKind kind, double share, const Vec3d& direction, const CastRay& from, Node node, const Place& here,
                 const Media& media) {
        const CastRay next{kind, from.depth + 1, from.weight * share};
        if (next.depth > options_.depth) {
            observer_.cut(next, node, Ending::depth);
            return {0, 0, 0};
        }
        if (!(next.weight > options_.threshold)) {
            observer_.cut(next, node, Ending::threshold);
            return {0, 0, 0};
        }
        return share * color(next, node, leaving(here, direction, infinity, options_.start), media);
    }

    bool casts_shadows() const { return Model::feelers && options_.shadows == WhittedOptions::Shadows::cast; }

    // I_local: emission, the ambient light's share, and Phong's two terms of every light that is seen.
    Color local_color(const Place& here, Node node) {
        const Finish& material = here.material;
        Color color = material.unlit;
        if (lighting_.lamps.empty()) return color;
        const Color* plain = std::get_if<Color>(&material.diffuse);
        Color patterned;
        if constexpr (!Model::plain)
            if (!plain) patterned = color_at(material.diffuse, here.at.position, here.at.normal);
        const Color& diffuse = Model::plain || plain ? *plain : patterned;
        const bool turned = !here.front && (Model::plain || options_.lit == WhittedOptions::Lit::viewers_side);
        const Side side = turned ? Side::inner : Side::outer;
        Vec3d normal = turned ? -here.at.normal : here.at.normal;
        const bool smooth = Surfaces::may_be_smooth && is_smooth(*here.at.object);
        const bool at_corners = smooth && here.at.object->shading == Shading::gouraud;
        Vec3d shading_normal = turned ? -here.at.shading_normal : here.at.shading_normal;
        Vec3d lit_normal = smooth ? shading_normal : normal;
        std::size_t number = 0;
        for (const Lamp& lamp : lighting_.lamps) {
            const std::size_t i = number++;
            auto light = light_of(lamp, here.at.position);
            // A surface may be in its own light. Without shadows it never is: where the dark side of a mesh begins is left
            // to its smooth normals, which know nothing of facets.
            if (!light || (!(dot(normal, light->to_light) > 0) && (!smooth || casts_shadows()))) continue;
            if (smooth && !at_corners && !(dot(lit_normal, light->to_light) > 0)) continue;
            const Ray felt = casts_shadows() ? leaving(here, light->to_light, length_of_feeler(*light), options_.start) : Ray{};
            if (casts_shadows() && is_blocked(i, felt, node)) continue;
            const Color& arriving = Model::plain ? lamp.color : light->color;
            const LitPoint point{here.at.position, lit_normal, viewer_of(here)};
            Color brought = at_corners ? between_corners(lamp, lit_corners(here, side, scene_.camera, options_), here.at, diffuse, material)
                                       : reflected_light(light->to_light, arriving, point, diffuse, material);
            if (casts_shadows()) observer_.felt(node, i, felt, Ending::reached, brought);
            color += brought;
        }
        return color;
    }

    [[gnu::always_inline]] static std::optional<Illumination> light_of(const Lamp& lamp, const Vec3d& point) {
        if constexpr (Model::plain) return plain_illumination(lamp, point);
        else return illumination(lamp, point);
    }

    Vec3d viewer_of(const Place& here) const { return Model::plain ? -here.direction : to_viewer(here, options_); }

    // Whether something is in a light's way.
    bool is_blocked(std::size_t number, const Ray& felt, Node node) {
        if constexpr (Model::feelers) {
            traversal_.toward(number);
            if (!surfaces_.occluded(felt, traversal_)) return false;
            observer_.felt(node, number, felt, Ending::blocked, {0, 0, 0});
        }
        return Model::feelers;
    }

    const Scene& scene_;
    const Surfaces& surfaces_;
    const Lighting& lighting_;
    const WhittedOptions& options_;
    Traversal& traversal_;
    Observer observer_;
};

}  // namespace raylab

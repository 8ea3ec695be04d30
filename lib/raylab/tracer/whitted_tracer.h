#pragma once

#include "raylab/scene/pigment.h"
#include "raylab/tracer/illumination.h"
#include "raylab/tracer/media_beside.h"
#include "raylab/tracer/ray_observers.h"
#include "raylab/tracer/reflected_light.h"
#include "raylab/tracer/whitted.h"

#include <array>
#include <limits>

// Whitted's recursion itself. Programs call whitted.h; here it is a template on who looks on and on what it must be able
// to do, so that what a picture does not need costs it nothing, not even a question.

namespace raylab {

/// What a tracer is compiled to be able to do.
struct AllAbilities {
    static constexpr bool feelers = true;    // shadow rays
    static constexpr bool recursion = true;  // reflected and transmitted rays
};
struct LocalLightOnly {
    static constexpr bool feelers = false;
    static constexpr bool recursion = false;
};

/// Traces eye rays, one after the other.
template <class Observer, class Abilities = AllAbilities>
class WhittedTracer {
public:
    using Node = typename Observer::Node;

    WhittedTracer(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options, Traversal& traversal,
           Observer observer)
        : scene_(scene), accelerator_(accelerator), options_(options), traversal_(traversal), observer_(observer) {}

    /// The colour along an eye ray that begins in these media.
    Color operator()(const Ray& eye_ray, const Media& around_eye) {
        return color({RayKind::eye, 1, 1}, {}, eye_ray, around_eye);
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    Color color(const CastRay& cast, Node parent, const Ray& ray, const Media& media) {
        const Node node = observer_.cast(cast, parent, ray);
        const auto hit = accelerator_.closest(ray, traversal_);
        if (!hit) return background(node);
        const SurfacePoint at = surface_point(scene_, ray, *hit);
        observer_.met(node, at, hit->t);
        return color_from(cast, node, place_of(ray, *hit, at), media);
    }

    Place place_of(const Ray& ray, const Hit& hit, const SurfacePoint& at) const {
        Place here = place(scene_, ray, hit, at);
        if constexpr (Abilities::feelers || Abilities::recursion) here.beside = detail::beside(at, here.normal);
        return here;
    }

    Color background(Node node) {
        observer_.missed(node, scene_.background.color);
        return scene_.background.color;
    }

    Color color_from(const CastRay& cast, Node node, const Place& here, const Media& media) {
        const Material& material = here.material;
        if (!Abilities::recursion || (material.kr == 0 && material.kt == 0)) return diffuse_color(here, node);
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
            const auto hit = accelerator_.closest(ray, traversal_);
            if (!hit) return background(node);
            const SurfacePoint at = surface_point(scene_, ray, *hit);
            observer_.met(node, at, hit->t);
            const Place here = place_of(ray, *hit, at);
            if (here.material.kt == 0) return color_from(cast, node, here, media);
            const Beside beside = media_beside(here, media);
            if (!is_hidden(beside)) return color_from(cast, node, here, media);
            media = beside.behind;
            ray = onward(here);
        }
    }

    Color diffuse_color(const Place& here, Node node) {
        const Color local = local_color(here, node);
        observer_.shaded(node, local, Ending::diffuse);
        return local;
    }

    Color branched_color(const CastRay& cast, Node node, const Place& here, const Branches& branches, const Media& before,
                         const Media& behind) {
        const Color local = local_color(here, node);
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
        return share * color(next, node, leaving(here, direction), media);
    }

    Ray leaving(const Place& here, const Vec3d& direction, double length = infinity) const {
        const RayStart& start = options_.start;
        if (start.offset == RayStart::Offset::error_bounded && dot(here.normal, direction) > 0)
            return detail::ray_begun(here.beside, here.at, direction, length, start.leaving);
        return ray_from(here.at, direction, length, start, here.ray, here.t);
    }

    // Straight on, whatever the options say of leaving: it does not count for the depth, so it must get away from here.
    static Ray onward(const Place& here) { return ray_from(here.at, here.direction, infinity, RayStart{}, here.ray, here.t); }

    bool casts_shadows() const { return Abilities::feelers && options_.shadows == WhittedOptions::Shadows::cast; }

    // I_local: emission, the ambient light's share, and Phong's two terms of every light that is seen.
    Color local_color(const Place& here, Node node) {
        const Material& material = here.material;
        Color color = material.emission + material.ambient * scene_.background.ambient;
        if (scene_.lights.empty()) return color;
        const Color diffuse = color_at(material.diffuse, here.at.position, here.at.normal);
        const double side = here.front || options_.lit == WhittedOptions::Lit::outer_side ? 1 : -1;
        const Vec3d normal = side * here.at.normal;
        const bool smooth = is_smooth(*here.at.object);
        const bool at_corners = smooth && here.at.object->shading == Shading::gouraud;
        const LitPoint point{here.at.position, smooth ? side * here.at.shading_normal : normal, to_viewer(here, options_)};
        std::size_t number = 0;
        for (const Light& lamp : scene_.lights) {
            const std::size_t i = number++;
            const auto light = illumination(lamp, here.at.position);
            // A surface may be in its own light. Without shadows it never is: where the dark side of a mesh begins is left
            // to its smooth normals, which know nothing of facets.
            if (!light || (!(dot(normal, light->to_light) > 0) && (!smooth || casts_shadows()))) continue;
            if (smooth && !at_corners && !(dot(point.normal, light->to_light) > 0)) continue;
            const Ray felt = casts_shadows() ? leaving(here, light->to_light, length_of_feeler(*light)) : Ray{};
            if (casts_shadows() && is_blocked(i, felt, node)) continue;
            const Color brought = at_corners ? between_corners(lamp, lit_corners(here, side), here.at, diffuse, material)
                                             : reflected_light(*light, point, diffuse, material);
            if (casts_shadows()) observer_.felt(node, i, felt, Ending::reached, brought);
            color += brought;
        }
        return color;
    }

    std::array<LitPoint, 3> lit_corners(const Place& here, double side) const {
        const auto lit = [&](const Corner& corner) -> LitPoint {
            return {corner.position, side * corner.normal, to_viewer(here, corner.position, scene_.camera, options_)};
        };
        const auto [a, b, c] = corners(here.at);
        return {lit(a), lit(b), lit(c)};
    }

    // Whether something is in a light's way.
    bool is_blocked(std::size_t number, const Ray& felt, Node node) {
        traversal_.toward(number);
        const bool blocked = accelerator_.occluded(felt, traversal_);
        if (blocked) observer_.felt(node, number, felt, Ending::blocked, {0, 0, 0});
        return blocked;
    }

    const Scene& scene_;
    const Accelerator& accelerator_;
    const WhittedOptions& options_;
    Traversal& traversal_;
    Observer observer_;
};

}  // namespace raylab

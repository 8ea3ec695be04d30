#pragma once

#include "raylab/scene/pigment.h"
#include "raylab/tracer/illumination.h"
#include "raylab/tracer/media.h"
#include "raylab/tracer/place.h"
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

namespace detail {

// The media on both sides of a transparent surface. Who leaves what was never entered has been inside from the start.
struct Beside {
    Media before, behind;
};

inline Beside media_beside(const Place& place, const Media& media) {
    const Object* object = place.at.object;
    if (place.front) return {media, media.entered(object)};
    const Media inside = media.contains(object) ? media : media.entered(object);
    return {inside, inside.left(object)};
}

}  // namespace detail

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
    using Beside = detail::Beside;
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    Color color(const CastRay& cast, Node parent, const Ray& ray, const Media& media) {
        const Node node = observer_.cast(cast, parent, ray);
        const auto hit = accelerator_.closest(ray, traversal_);
        if (!hit) return background(node);
        const SurfacePoint at = surface_point(scene_, ray, *hit);
        observer_.met(node, at, hit->t);
        return color_from(cast, node, place(scene_, ray, *hit, at), media);
    }

    Color background(Node node) {
        observer_.missed(node, scene_.background.color);
        return scene_.background.color;
    }

    Color color_from(const CastRay& cast, Node node, const Place& here, const Media& media) {
        const Material& material = here.material;
        if (!Abilities::recursion || (material.kr == 0 && material.kt == 0)) return diffuse_color(here, node);
        if (material.kt == 0) return branched_color(cast, node, here, {.reflected = material.kr}, media, media);
        const Beside beside = detail::media_beside(here, media);
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
            const Place here = place(scene_, ray, *hit, at);
            if (here.material.kt == 0) return color_from(cast, node, here, media);
            const Beside beside = detail::media_beside(here, media);
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

    Ray leaving(const Place& here, const Vec3d& direction) const {
        return ray_from(here.at, direction, infinity, options_.start, here.ray, here.t);
    }

    // Straight on, whatever the options say of leaving: it does not count for the depth, so it must get away from here.
    static Ray onward(const Place& here) { return ray_from(here.at, here.direction, infinity, RayStart{}, here.ray, here.t); }

    // I_local: emission, the ambient light's share, and Phong's two terms of every light that is seen.
    Color local_color(const Place& here, Node node) {
        const Material& material = here.material;
        Color color = material.emission + material.ambient * scene_.background.ambient;
        if (scene_.lights.empty()) return color;
        const Color diffuse = color_at(material.diffuse, here.at.position, here.at.normal);
        const double side = here.front || options_.lit == WhittedOptions::Lit::outer_side ? 1 : -1;
        const LitPoint point{here.at.position, side * here.at.shading_normal, to_viewer(here)};
        const bool at_corners = here.at.object->shading == Shading::gouraud && is_smooth(*here.at.object);
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
            const auto light = illumination(scene_.lights[i], here.at.position);
            if (!light || is_behind(*light, side * here.at.normal)) continue;
            if (!at_corners && !(dot(point.normal, light->to_light) > 0)) continue;
            color += seen_light(i, *light, here, node, [&] {
                return at_corners ? between_corners(scene_.lights[i], lit_corners(here, side), here.at, diffuse, material)
                                  : reflected_light(*light, point, diffuse, material);
            });
        }
        return color;
    }

    // Whether a surface is in its own light. Without shadows it never is: where the dark side of a mesh begins is left to
    // its smooth normals, which know nothing of facets.
    bool is_behind(const Illumination& light, const Vec3d& normal) const {
        return Abilities::feelers && options_.shadows == WhittedOptions::Shadows::cast && !(dot(normal, light.to_light) > 0);
    }

    std::array<LitPoint, 3> lit_corners(const Place& here, double side) const {
        const auto lit = [&](const Corner& corner) -> LitPoint {
            return {corner.position, side * corner.normal, to_viewer(here, corner.position)};
        };
        const auto [a, b, c] = corners(here.at);
        return {lit(a), lit(b), lit(c)};
    }

    // What a light brings, if nothing is in its way.
    template <class Brought>
    Color seen_light(std::size_t number, const Illumination& light, const Place& here, Node node, const Brought& brought) {
        if constexpr (!Abilities::feelers) return brought();
        if (options_.shadows == WhittedOptions::Shadows::none) return brought();
        const Ray felt = feeler(here.at, light, options_.start, here.ray, here.t);
        traversal_.toward(number);
        if (accelerator_.occluded(felt, traversal_)) {
            observer_.felt(node, number, felt, Ending::blocked, {0, 0, 0});
            return {0, 0, 0};
        }
        const Color color = brought();
        observer_.felt(node, number, felt, Ending::reached, color);
        return color;
    }

    Vec3d to_viewer(const Place& here) const {
        return options_.viewer == WhittedOptions::Viewer::at_infinity ? options_.to_viewer : -here.direction;
    }

    // From another point of the surface that the ray met. An orthographic eye is nowhere: all its rays are parallel.
    Vec3d to_viewer(const Place& here, const Vec3d& position) const {
        const bool local = options_.viewer == WhittedOptions::Viewer::local;
        if (!local || std::holds_alternative<Orthographic>(scene_.camera.projection)) return to_viewer(here);
        return glm::normalize(convert<double>(here.ray.origin) - position);
    }

    const Scene& scene_;
    const Accelerator& accelerator_;
    const WhittedOptions& options_;
    Traversal& traversal_;
    Observer observer_;
};

}  // namespace raylab

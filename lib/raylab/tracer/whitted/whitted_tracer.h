#pragma once

#include "raylab/scene/background.h"
#include "raylab/tracer/media/media_beside.h"
#include "raylab/tracer/picture/models.h"
#include "raylab/tracer/shading/local_light.h"
#include "raylab/tracer/whitted/ray_observers.h"

// Whitted's recursion itself, as chapter 07's pseudo-code has it. Programs call whitted.h; here it is a template on who
// observes the rays and on the model (models.h). What a ray makes on its way is not const: GCC 12 keeps constant
// aggregates in memory, where others stay in registers.

namespace raylab {

/// Traces eye rays, one after the other.
template <class Observer, class Model>
class WhittedTracer {
public:
    using Node = typename Observer::Node;
    using Surfaces = typename Model::Surfaces;

    WhittedTracer(const Scene& scene, const Surfaces& surfaces, const Lighting& lighting, const WhittedOptions& options,
                  Traversal& traversal, Observer observer)
        : scene_(scene),
          surfaces_(surfaces),
          lighting_(lighting),
          options_(options),
          traversal_(traversal),
          observer_(observer),
          local_color_(scene, surfaces, lighting, options, traversal, observer) {}

    /// The colour along an eye ray that begins in these media.
    Color operator()(const Ray& eye_ray, const Media& around_eye) {
        return color({RayKind::eye, 1, 1}, {}, eye_ray, around_eye);
    }

private:
    // I = I_local + k_r I_reflected + k_t I_transmitted where the ray hits, the background where it does not.
    Color color(const CastRay& cast, Node parent, const Ray& ray, const Media& media) {
        return color(cast, parent, ray, media, [&](Node node, const ShadingPoint& hidden, const Media& behind) {
            return color_behind(cast, node, onward(hidden), behind);
        });
    }

    // The same, by this step. A surface that is hidden inside of a stronger medium changes nothing: the colour is that
    // of what lies behind it, which on_hidden() says.
    template <class OnHidden>
    [[gnu::always_inline]] Color color(const CastRay& cast, Node parent, const Ray& ray, const Media& media,
                                       const OnHidden& on_hidden) {
        const Node node = observer_.cast(cast, parent, ray);
        auto hit = surfaces_.closest(ray, traversal_);
        if (!hit) return background(node, ray);
        SurfacePoint at = surfaces_.point(ray, *hit);
        observer_.hit_found(node, at, hit->t);
        ShadingPoint here = place_of(ray, hit->t, at);
        if (!Model::media || here.material.kt == 0) return opaque_color(cast, node, here, media);
        MediaBeside beside(scene_, here, media);
        if (!beside.is_hidden()) return transparent_color(cast, node, here, beside);
        observer_.shaded(node, {0, 0, 0}, Ending::branched);
        return on_hidden(node, here, beside.behind());
    }

    // Behind hidden surfaces: in a loop, since they do not count for the depth, and a scene may have a million of them.
    [[gnu::noinline]] Color color_behind(CastRay cast, Node parent, Ray ray, Media media) {
        cast.kind = RayKind::transmitted;
        for (;;) {
            bool is_hidden = false;
            const Color found =
                color(cast, parent, ray, media, [&](Node node, const ShadingPoint& hidden, const Media& behind) {
                    is_hidden = true;
                    parent = node;
                    ray = onward(hidden);
                    media = behind;
                    return Color{};
                });
            if (!is_hidden) return found;
        }
    }

    ShadingPoint place_of(const Ray& ray, double t, const SurfacePoint& at) const {
        ShadingPoint here = shading_point(lighting_, ray, t, at);
        if constexpr (Model::shadow_rays || Model::recursion) here.beside = start_beside(at, here.normal);
        return here;
    }

    Color background(Node node, const Ray& ray) {
        const Color color = background_color(scene_.background, ray.direction);
        observer_.missed(node, color);
        return color;
    }

    [[gnu::always_inline]] Color opaque_color(const CastRay& cast, Node node, const ShadingPoint& here,
                                              const Media& media) {
        Color sum = local_color_(here, node);
        const bool mirrors = Model::recursion && here.material.kr != 0;
        observer_.shaded(node, sum, mirrors ? Ending::branched : Ending::diffuse);
        if (mirrors) sum += mirrored_color(here.material.kr, cast, node, here, media);
        return sum;
    }

    [[gnu::noinline]] Color transparent_color(const CastRay& cast, Node node, const ShadingPoint& here,
                                              const MediaBeside& beside) {
        Color sum = local_color_(here, node);
        observer_.shaded(node, sum, Ending::branched);
        Branches branches = branches_at(here, beside.ior_before(), beside.ior_behind(), options_.reflectance);
        sum += mirrored_color(branches.reflected, cast, node, here, beside.before());
        sum += refracted_color(branches, cast, node, here, beside.behind());
        return sum;
    }

    [[gnu::always_inline]] Color mirrored_color(double share, const CastRay& cast, Node node, const ShadingPoint& here,
                                                const Media& media) {
        if (!(share > 0) && !(options_.threshold < 0)) return {0, 0, 0};
        const CastRay next = branch(RayKind::reflected, share, cast);
        if (!is_followed(next, node)) return {0, 0, 0};
        return share * color(next, node, mirrored(here, options_.start), media);
    }

    [[gnu::always_inline]] Color refracted_color(const Branches& branches, const CastRay& cast, Node node,
                                                 const ShadingPoint& here, const Media& media) {
        if (!branches.refracted) {
            observer_.cut({RayKind::transmitted, cast.depth + 1, 0}, node, Ending::total_internal_reflection);
            return {0, 0, 0};
        }
        const CastRay next = branch(RayKind::transmitted, branches.transmitted, cast);
        if (!is_followed(next, node)) return {0, 0, 0};
        return branches.transmitted * color(next, node, leaving(here, *branches.refracted, options_.start), media);
    }

    static CastRay branch(RayKind kind, double share, const CastRay& from) {
        return {kind, from.depth + 1, from.throughput * share};
    }

    bool is_followed(const CastRay& next, Node node) {
        if (next.depth > options_.depth)
            observer_.cut(next, node, Ending::depth);
        else if (!(next.throughput > options_.threshold))
            observer_.cut(next, node, Ending::threshold);
        else
            return true;
        return false;
    }

    const Scene& scene_;
    const Surfaces& surfaces_;
    const Lighting& lighting_;
    const WhittedOptions& options_;
    Traversal& traversal_;
    Observer observer_;
    LocalLight<Observer, Model> local_color_;
};

}  // namespace raylab

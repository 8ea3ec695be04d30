#pragma once

#include "raylab/scene/background.h"
#include "raylab/scene/pigment.h"
#include "raylab/tracer/media/media_beside.h"
#include "raylab/tracer/shading/any_surface.h"
#include "raylab/tracer/whitted/ray_observers.h"
#include "raylab/transport/light/area_lights.h"
#include "raylab/transport/path/next_direction.h"
#include "raylab/transport/path/path_vertex.h"
#include "raylab/transport/path/transport_model.h"
#include "raylab/transport/path/transport_options.h"
#include "raylab/transport/power_heuristic.h"

#include <numbers>

// One path from the eye, as lesson 15 has it in pseudo-code: at each surface it asks the lights, chooses one lobe, and
// goes on in a direction of that lobe. Distributed ray tracing is the same machine that never goes on from the diffuse
// lobe; path tracing does (Kajiya, "The Rendering Equation", SIGGRAPH 1986).

namespace raylab {

/// A scene made ready for paths: all tiles share it.
template <class Model>
struct PathStage {
    PathStage(const Scene& its_scene, const Accelerator& accelerator)
        : scene(its_scene), surfaces(its_scene, accelerator), lighting(its_scene), area_lights(its_scene) {}

    const Scene& scene;
    const typename Model::Surfaces surfaces;
    const Lighting lighting;
    const AreaLights area_lights;
};

/// Traces paths, one after the other. What a path does at every vertex is inlined into scatter(), and what only some
/// scenes need is kept out of it: 4 % fewer instructions, and a scene pays at most 2 % for what it lacks
/// (tests/bench/needs/measure).
template <class Observer, class Model>
class PathTracer {
public:
    using Node = typename Observer::Node;
    using Surfaces = typename Model::Surfaces;

    PathTracer(const PathStage<Model>& stage, const TransportOptions& options, const Sampler& sampler,
               Traversal& traversal, Observer observer)
        : scene_(stage.scene),
          surfaces_(stage.surfaces),
          lighting_(stage.lighting),
          area_lights_(stage.area_lights),
          anything_emits_(!area_lights_.empty() || !area_lights_.unsampled().empty()),
          options_(options),
          sampler_(sampler),
          traversal_(traversal),
          observer_(observer) {
        if (!lighting_.lights.empty()) traversal.toward(lighting_.lights.size() - 1);  // makes room for all
    }

    /// The radiance along an eye ray that begins in these media.
    Color operator()(const Ray& eye_ray, const Media& around_eye, const SamplePlace& place) {
        place_ = place;
        radiance_ = Color(0);
        Path path{.ray = eye_ray, .media = around_eye};
        while (step(path)) {
        }
        return radiance_;
    }

private:
    // The last ray of a path, and what led to it.
    struct Path {
        Ray ray;
        Media media;
        RayKind kind = RayKind::eye;
        Color throughput{1, 1, 1};
        int depth = 1;   // of `ray`
        int vertex = 0;  // the number of surfaces that it scattered at
        Node parent = {};
        Vec3d from = {};     // where `ray` begins, if a lobe chose its direction,
        double density = 0;  // ... with this density per steradian; 0: by no choice, or by a sharp lobe
    };

    struct Vertex : PathVertex<typename Model::Lobes> {
        VertexNumbers numbers;
        Node node;
    };

    // Adds what the path's last ray brings, and sends it on. False: it ends.
    bool step(Path& path) {
        const CastRay cast{path.kind, path.depth, largest(path.throughput)};
        const Node node = observer_.cast(cast, path.parent, path.ray);
        const auto hit = surfaces_.closest(path.ray, traversal_);
        if (!hit) {
            see_background(path, node);
            return false;
        }
        const SurfacePoint at = surfaces_.point(path.ray, *hit);
        observer_.hit_found(node, at, hit->t);
        const ShadingPoint here = shading_point(lighting_, path.ray, hit->t, at);
        if (here.material.kt == 0) return scatter(path, node, here, path.media, path.media, {});
        const MediaBeside beside(scene_, here, path.media);
        if (!beside.is_hidden())
            return scatter(path, node, here, beside.before(), beside.behind(),
                           {beside.ior_before(), beside.ior_behind()});
        observer_.shaded(node, {0, 0, 0}, Ending::branched);  // inside of a stronger medium nothing changes
        const Media behind = beside.behind();
        const float time = path.ray.time;
        path.ray = onward(here);
        path.ray.time = time;
        path.media = behind;
        path.parent = node;
        return true;
    }

    void see_background(const Path& path, Node node) {
        const Color color = background_color(scene_.background, path.ray.direction);
        radiance_ += path.throughput * color;
        observer_.missed(node, color);
        observer_.chosen(node, path.density, path.throughput * color);
    }

    [[gnu::noinline]] bool scatter(Path& path, Node node, const ShadingPoint& here, const Media& before,
                                   const Media& behind, const Interface& interface) {
        const bool faces = dot(here.shading, here.direction) < 0;
        const LocalFrame frame = frame_around(faces ? here.shading : here.normal);
        const Color diffuse = color_at(here.material.diffuse, here.at.position, here.at.normal);
        const Vec3d wo = frame.to_local(-here.direction);
        Vertex v{{here, frame, wo, interface, Model::lobes(here.material, diffuse, wo, interface, options_.shares)},
                 {sampler_, place_, path.vertex},
                 node};
        if (path.depth < options_.depth) v.choice = lobe_choice(v.lobes, options_.followed);

        Color local(0), direct = from_lights(v);
        if (Model::area_lights && anything_emits_) [[unlikely]] {
            local = emitted(path, here);
            direct += from_area_light(v, path.throughput);
        }
        if (options_.followed == Followed::sharp_and_glossy) local += here.material.unlit - here.material.emission;
        local += direct;
        radiance_ += path.throughput * local;
        const bool is_last = path.depth >= options_.depth;  // so points on lights alone count here, and in full
        observer_.shaded(node, local, is_last ? Ending::depth : v.choice.any() ? Ending::branched : Ending::diffuse);
        observer_.chosen(node, path.density, path.throughput * local);
        return v.choice.any() && send_on(path, v, before, behind);
    }

    // The surface's own light. Where the ray's direction was chosen with a density, points on lights could have been
    // chosen too, and each way counts its part.
    [[gnu::noinline]] Color emitted(const Path& path, const ShadingPoint& here) const {
        if (here.material.emission == Color(0)) return Color(0);
        if (path.density == 0 || options_.strategy == LightStrategy::lobes) return here.material.emission;
        const double by_lights = area_lights_.pdf(path.from, here.at.primitive, here.at.position, here.ray.time);
        if (!(by_lights > 0)) return here.material.emission;
        if (options_.strategy == LightStrategy::lights) return Color(0);
        return power_heuristic(path.density, by_lights) * here.material.emission;
    }

    // Point, spot and distant lights: no lobe finds them, so each is asked. `color` is the radiance that a light gives
    // to a white diffuse surface that faces it: the irradiance is pi times that.
    [[gnu::always_inline]] Color from_lights(const Vertex& v) {
        Color sum(0);
        for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
            const auto light = illumination(lighting_.lights[i], v.here.at.position);
            if (!light) continue;
            const Vec3d wi = v.frame.to_local(light->to_light);
            Color seen = v.scattered(light->to_light, wi) * std::numbers::pi;
            if (options_.followed == Followed::sharp_and_glossy) seen += v.highlight(light->to_light);
            if (seen == Color(0)) continue;
            const Color brought = seen * light->color;
            traversal_.light = i;
            const Ray ray = ray_to(v, light->to_light, light->distance);
            const bool blocked = surfaces_.occluded(ray, traversal_);
            observer_.shadow_ray_cast(v.node, i, ray, blocked ? Ending::blocked : Ending::reached,
                                      blocked ? Color(0) : brought);
            if (!blocked) sum += brought;
        }
        return sum;
    }

    // One point on one surface that emits.
    [[gnu::noinline]] Color from_area_light(const Vertex& v, const Color& throughput) {
        if (area_lights_.empty() || v.lobes.spread.empty()) return Color(0);
        const double choice = area_lights_.leave_a_choice() ? v.numbers.one(purpose::light_choice) : 0;
        const auto light =
            area_lights_.sample(v.here.at.position, choice, v.numbers.two(purpose::light_point), v.here.ray.time);
        if (!light || !(light->pdf > 0)) return Color(0);
        const Vec3d wi = v.frame.to_local(light->direction);
        const Color seen = v.weighted(light->direction, wi, light->pdf, options_.strategy);
        if (seen == Color(0)) return Color(0);
        const Color brought = seen * light->radiance / light->pdf;
        const Ray ray = ray_to(v, *light);
        const bool blocked = surfaces_.occluded(ray, traversal_);
        const Color arrived = blocked ? Color(0) : brought;
        const Node node =
            observer_.shadow_ray_cast(v.node, RayNode::none, ray, blocked ? Ending::blocked : Ending::reached, arrived);
        observer_.chosen(node, light->pdf, throughput * arrived);
        return blocked ? Color(0) : brought;
    }

    // The path's next ray. False: it ends here.
    [[gnu::always_inline]] bool send_on(Path& path, const Vertex& v, const Media& before, const Media& behind) {
        const auto next = next_direction(v, v.numbers);
        if (!next) return false;
        const Color throughput = path.throughput * next->weight;
        const bool passes = dot(v.here.normal, next->direction) < 0;
        const RayKind kind = next->is_diffuse ? RayKind::diffuse : passes ? RayKind::transmitted : RayKind::reflected;
        const CastRay cast{kind, path.depth + 1, largest(throughput)};
        const auto chance = chance_survived(throughput, v.numbers);
        if (!chance) {
            observer_.cut(cast, v.node, Ending::roulette);
            return false;
        }
        const Media media = passes ? behind : before;
        const Vec3d from = v.here.at.position;
        const Ray ray = ray_on(v, next->direction);
        path = {.ray = ray,
                .media = media,
                .kind = kind,
                .throughput = throughput / *chance,
                .depth = path.depth + 1,
                .vertex = path.vertex + 1,
                .parent = v.node,
                .from = from,
                .density = next->density};
        return true;
    }

    // Russian roulette: a path that carries little goes on with a chance as small, and then carries more. It costs no
    // bias. (Arvo and Kirk, "Particle Transport and Image Synthesis", SIGGRAPH 1990.) No path is sure to go on: in a
    // closed room that absorbs nothing it would do so for ever. Nothing: the path ends.
    static std::optional<double> chance_survived(const Color& throughput, const VertexNumbers& numbers) {
        constexpr int first = 3;  // short paths bring most of the light
        constexpr double most = 1 - 0x1p-10;
        if (numbers.vertex < first) return 1;
        const double chance = std::min(largest(throughput), most);
        if (!(numbers.one(purpose::roulette) < chance)) return std::nullopt;
        return chance;
    }

    Ray ray_to(const Vertex& v, const Vec3d& direction, double distance) const {
        return ray_to_length(v, direction, length_of_shadow_ray(distance));
    }

    // A ray to a surface that emits must not be stopped by it. Its floats begin beside the point, and where it comes in
    // at a slant they meet the surface well before the distance of the point: so it ends before the surface's plane
    // there.
    Ray ray_to(const Vertex& v, const LightSample& light) const {
        Ray ray = ray_to(v, light.direction, light.distance);
        const double rise = dot(light.normal, light.point - convert<double>(ray.origin));
        const double t = rise / dot(light.normal, convert<double>(ray.direction));
        if (t > 0) ray.range.max = std::min(ray.range.max, cast<float>(length_of_shadow_ray(t)));
        return ray;
    }

    Ray ray_on(const Vertex& v, const Vec3d& direction) const {
        return ray_to_length(v, direction, std::numeric_limits<double>::infinity());
    }

    // All rays of a path see the moment of its eye ray.
    Ray ray_to_length(const Vertex& v, const Vec3d& direction, double length) const {
        Ray ray = ray_from(v.here.at, direction, length, options_.start, v.here.ray, v.here.t);
        if constexpr (Model::time) ray.time = v.here.ray.time;
        return ray;
    }

    static double largest(const Color& c) { return std::max({c.x, c.y, c.z}); }

    const Scene& scene_;
    const Surfaces& surfaces_;
    const Lighting& lighting_;
    const AreaLights& area_lights_;
    const bool anything_emits_;
    const TransportOptions& options_;
    const Sampler& sampler_;
    Traversal& traversal_;
    Observer observer_;
    SamplePlace place_;
    Color radiance_{0, 0, 0};
};

}  // namespace raylab

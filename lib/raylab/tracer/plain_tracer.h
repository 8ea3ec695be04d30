#pragma once

#include "raylab/tracer/eye_picture.h"
#include "raylab/tracer/lighting.h"
#include "raylab/tracer/plain_sphere.h"
#include "raylab/tracer/ray_observers.h"
#include "raylab/tracer/reflected_light.h"

#include <span>

namespace raylab {

/// Traces eye rays where there is nothing but spheres, and all is plain: rays end where they meet a surface, and none is felt
/// for a light; lamps are points that shine alike at any distance, colours are the same all over, highlights are seen from
/// the eye and light counts on the side that it looks at. The pictures and counts are those of WhittedTracer. To ask for what
/// there might be else (a shape of another kind, a transform, a pattern, a cone of light) would take half as long as to draw
/// the picture.
template <class Observer, class Spheres>
class PlainTracer {
public:
    using Node = typename Observer::Node;

    PlainTracer(const Scene& scene, const Spheres& spheres, const Lighting& lighting, Observer observer)
        : background_(scene.background.color), spheres_(spheres), lamps_(lighting.lamps), observer_(observer) {}

    /// The colour along an eye ray.
    Color operator()(const Ray& ray) {
        auto met = color_met(ray);
        return met ? *met : background_;
    }

    /// The same as pictures store it.
    Pixel pixel(const Ray& ray) {
        auto met = color_met(ray);
        return met ? to_pixel(*met) : background_pixel_;
    }

    const TestCounts& tests() const { return memory_; }

private:
    // Absent: the ray misses all spheres.
    std::optional<Color> color_met(const Ray& ray) {
        const Node node = observer_.cast({RayKind::eye, 1, 1}, {}, ray);
        auto hit = spheres_.closest(ray, memory_);
        if (!hit) {
            observer_.missed(node, background_);
            return std::nullopt;
        }
        const PlainSphere& sphere = spheres_.sphere(*hit);
        SurfacePoint at = sphere.point(hit->near);
        observer_.met(node, at, hit->t);
        Vec3d direction = convert<double>(ray.direction);
        const bool outside = Spheres::is_outside(*hit, at, direction);
        Color local = outside ? local_color(sphere.outside, at.position, at.normal, direction)
                              : local_color(sphere.inside, at.position, -at.normal, direction);
        observer_.shaded(node, local, Ending::diffuse);
        return local;
    }

    // I_local: what the surface shows by itself, and Phong's two terms of every light.
    Color local_color(const PlainSphere::Coat& material, const Vec3d& position, const Vec3d& normal, const Vec3d& direction) const {
        if (lamps_.size() != 1) [[unlikely]] return lit_by_several(lamps_, material, position, normal, direction);
        return lit_by(lamps_.front(), material.unlit, material, position, normal, direction);
    }

    // Of copies, and apart: with one lamp nothing need be kept for another.
    [[gnu::noinline]] static Color lit_by_several(std::span<const Lamp> lamps, const PlainSphere::Coat& material, Vec3d position,
                                                  Vec3d normal, Vec3d direction) {
        Color color = material.unlit;
        for (const Lamp& lamp : lamps) color = lit_by(lamp, color, material, position, normal, direction);
        return color;
    }

    static Color lit_by(const Lamp& lamp, const Color& before, const PlainSphere::Coat& material, const Vec3d& position,
                        const Vec3d& normal, const Vec3d& direction) {
        Vec3d to_light = bearing_of_point(lamp, position).to_light;
        const double cosine = dot(normal, to_light);
        if (!(cosine > 0)) return before;
        const LitPoint point{position, normal, -glm::normalize(direction)};
        return before + reflected_light(cosine, to_light, lamp.color, point, material.color, material);
    }

    Color background_;
    Pixel background_pixel_ = to_pixel(background_);
    const Spheres& spheres_;
    std::span<const Lamp> lamps_;
    typename Spheres::Memory memory_;
    Observer observer_;
};

}  // namespace raylab

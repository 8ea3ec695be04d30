#pragma once

#include "raylab/sampling/sampler.h"
#include "raylab/tracer/refracted_direction.h"
#include "raylab/transport/path/path_vertex.h"
#include "raylab/transport/path/purposes.h"

#include <array>
#include <optional>

// Where a path goes on from a surface: along its mirrored or refracted ray, or in a direction that one of its lobes
// chooses.

namespace raylab {

/// The random numbers of one vertex of a path, by what they are for.
struct VertexNumbers {
    const Sampler& sampler;
    const SamplePlace& place;
    int vertex;

    double one(purpose::AtVertex use) const { return number(sampler, place, purpose::at(vertex, use)); }
    std::array<double, 2> two(purpose::AtVertex use) const { return pair(sampler, place, purpose::at(vertex, use)); }
};

struct NextDirection {
    Vec3d direction;
    Color weight;    // what the path's throughput is multiplied by
    double density;  // per steradian, of all lobes that could have chosen it; 0: sharp
    bool is_diffuse;
};

/// Mirrored about the shading normal, or about the surface's own where that would lead to the wrong side.
template <class Lobes>
Vec3d mirrored_direction(const PathVertex<Lobes>& v) {
    const auto about = [&](const Vec3d& n) { return v.here.direction - 2 * dot(v.here.direction, n) * n; };
    const Vec3d smooth = about(v.frame.z);
    return dot(smooth, v.here.normal) > 0 ? smooth : about(v.here.normal);
}

/// Refracted likewise; nothing where all light is mirrored.
template <class Lobes>
std::optional<Vec3d> direction_behind(const PathVertex<Lobes>& v) {
    const auto about = [&](const Vec3d& n) {
        return refracted_direction(v.here.direction, n, v.interface.ior_here, v.interface.ior_behind);
    };
    const auto smooth = about(v.frame.z);
    return smooth && dot(*smooth, v.here.normal) < 0 ? smooth : about(v.here.normal);
}

/// Chooses a lobe, and a direction of it. Nothing where the path ends. Inlined, since every path asks at every vertex.
template <class Lobes>
[[gnu::always_inline]] inline std::optional<NextDirection> next_direction(const PathVertex<Lobes>& v,
                                                                          const VertexNumbers& numbers) {
    const auto [index, chance] = v.choice.chosen([&] { return numbers.one(purpose::lobe_choice); });
    if (index == LobeChoice::mirrored)
        return NextDirection{mirrored_direction(v), Color(v.lobes.mirrored / chance), 0, false};
    if (index == LobeChoice::refracted) {
        const auto direction = direction_behind(v);
        if (!direction) return std::nullopt;
        return NextDirection{*direction, Color(v.lobes.refracted / chance), 0, false};
    }
    const auto& lobe = v.lobes.spread[index];
    const auto found = sample(lobe, v.wo, numbers.two(purpose::lobe_direction));
    if (!found) return std::nullopt;
    const Vec3d direction = v.frame.to_world(found->direction);
    if (!v.scatters_to(direction, found->direction)) return std::nullopt;
    const bool is_diffuse = std::holds_alternative<DiffuseLobe>(lobe);
    const double chosen_with = density(v.lobes, v.choice, v.wo, found->direction);
    return NextDirection{direction, v.followed(found->direction) / chosen_with, chosen_with, is_diffuse};
}

}  // namespace raylab

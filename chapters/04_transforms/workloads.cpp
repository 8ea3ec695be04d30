#include "workloads.h"

#include "raylab/sampling/sequence.h"

#include <functional>

namespace raylab::transforms {

namespace {

using Map = std::function<AffineSteps(RandomSequence&)>;

struct Kind {
    std::string name, about;
    Map map;
};

AffineSteps turned(RandomSequence& random) {
    return AffineSteps::rotate(random.unit_vector(), random.between(10, 350));
}

AffineSteps sheared(RandomSequence& random) {
    AffineSteps shear;
    shear.columns = {Vec3d{1, 0, 0}, Vec3d{random.between(-2, 2), 1, 0},
                     Vec3d{random.between(-2, 2), random.between(-2, 2), 1}};
    return shear;
}

Vec3d somewhere(RandomSequence& random, double distance) { return random.unit_vector() * distance; }

AffineSteps stretched(RandomSequence& random, double largest) {
    const double x = random.between(1, largest);
    return AffineSteps::scale({x, random.between(1, largest), 1}).then(turned(random));
}

AffineSteps moved(const AffineSteps& map, RandomSequence& random, double distance) {
    return map.then(AffineSteps::translate(somewhere(random, distance)));
}

std::vector<Kind> kinds() {
    return {
        {"turned", "a rotation and a step aside", [](auto& r) { return moved(turned(r), r, 2); }},
        {"stretched", "scaled up to ten times along two axes", [](auto& r) { return moved(stretched(r, 10), r, 2); }},
        {"sheared", "sheared along all axes", [](auto& r) { return moved(sheared(r), r, 2); }},
        {"mirrored", "sheared and mirrored: a negative determinant",
         [](auto& r) {
             return moved(sheared(r).then(AffineSteps::scale({-1, 1, 1})), r, 2);
         }},
        {"far", "sheared, a hundred kilometres from the origin", [](auto& r) { return moved(sheared(r), r, 1e5); }},
        {"flattened", "pressed to a ten-thousandth of its height",
         [](auto& r) {
             return moved(AffineSteps::scale({1, 1, 1e-4}).then(turned(r)), r, 2);
         }},
        {"tiny", "sheared, and scaled to 1e-14",
         [](auto& r) {
             return moved(sheared(r).then(AffineSteps::scale({1e-14, 1e-14, 1e-14})), r, 2e-14);
         }},
    };
}

// A ray from a few radii away, aimed at a point slightly inside or outside the silhouette as seen from the origin.
Ray aimed(const Affine& placement, RandomSequence& random) {
    const Vec3d away = random.unit_vector();
    const Vec3d aside = glm::normalize(cross(away, random.unit_vector()));
    const double reach = 4;  // in radii, in object space
    // The silhouette's radius in the plane through the center, as seen from there.
    const double rim = 1 / std::sqrt(1 - 1 / (reach * reach));
    const double target = rim * (1 + random.between(-1e-5, 1e-5));
    const Vec3f origin = convert<float>(transform_point(placement, away * reach));
    const Vec3d world_target = transform_point(placement, aside * target);
    return {.origin = origin, .direction = convert<float>(world_target - convert<double>(origin))};
}

constexpr std::size_t rays_per_map = 20;

SphereWorkload sphere_workload(const Kind& kind, std::uint64_t number, std::size_t rays, std::uint64_t seed) {
    SphereWorkload workload{.name = kind.name, .about = kind.about};
    for (std::size_t i = 0; i < rays; ++i) {
        RandomSequence random(seed, number, i);
        if (i % rays_per_map == 0) workload.data.push_back(kind.map(random).rounded());
        workload.queries.push_back({aimed(workload.data.back(), random), workload.data.size() - 1});
    }
    return workload;
}

NormalWorkload normal_workload(const Kind& kind, std::uint64_t number, std::size_t normals, std::uint64_t seed) {
    NormalWorkload workload{.name = kind.name, .about = kind.about};
    for (std::size_t i = 0; i < normals; ++i) {
        RandomSequence random(seed, 100 + number, i);
        const Affine map = kind.map(random).rounded();
        workload.queries.push_back({map.columns, convert<float>(random.unit_vector())});
    }
    return workload;
}

}  // namespace

std::vector<SphereWorkload> sphere_workloads(std::size_t rays, std::uint64_t seed) {
    std::vector<SphereWorkload> workloads;
    for (const auto& kind : kinds()) workloads.push_back(sphere_workload(kind, workloads.size(), rays, seed));
    return workloads;
}

std::vector<NormalWorkload> normal_workloads(std::size_t normals, std::uint64_t seed) {
    std::vector<NormalWorkload> workloads;
    for (const auto& kind : kinds())
        if (kind.name != "far")  // a translation does not change normals
            workloads.push_back(normal_workload(kind, workloads.size(), normals, seed));
    return workloads;
}

}  // namespace raylab::transforms

#include "octree_workloads.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <cmath>

namespace raylab::octrees {

std::shared_ptr<const Scene> hall(int levels) {
    Mesh room = trefoil_knot(0.35, levels);
    for (Vec3f& v : room.vertices) v = v * 0.25f + Vec3f(-3, 1.2f, -3);
    constexpr float half = 6, height = 6;
    add_parallelogram(room, {-half, 0, -half}, {0, 0, 2 * half}, {2 * half, 0, 0});
    add_parallelogram(room, {-half, 0, -half}, {2 * half, 0, 0}, {0, height, 0});
    add_parallelogram(room, {-half, 0, -half}, {0, height, 0}, {0, 0, 2 * half});
    auto scene = std::make_shared<Scene>(mesh_scene(std::make_shared<Mesh>(std::move(room)), "hall"));
    scene->camera.position = {1.5, 3.5, 2};
    scene->camera.target = {-2.6, 1.3, -2.6};
    return scene;
}

StructureWorkload dust_rays(double distance, std::size_t rays, std::uint64_t seed) {
    constexpr int grains = 2000;
    constexpr double size = 0.004;
    auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t i = 0; i < grains; ++i) {
        RandomSequence random(seed, i);
        const auto within = [&](double half) {
            const double x = half * (2 * random.next() - 1), y = half * (2 * random.next() - 1);
            return convert<float>(Vec3d{x, y, half * (2 * random.next() - 1)});
        };
        const Vec3f a = within(1);
        const Vec3f b = a + within(size);
        add(*mesh, {a, b, a + within(size)});
    }
    StructureWorkload workload{distance < 10 ? "dust" : "dust from afar",
                               "at grains, which are much smaller than the way to them",
                               std::make_shared<Scene>(mesh_scene(mesh, "dust"))};
    for (std::size_t i = 0; i < rays; ++i) {
        RandomSequence random(seed + 1, i);
        const Triangle grain = mesh->triangle(static_cast<std::size_t>(random.whole(0, grains - 1)));
        const Vec3d middle = (convert<double>(grain.a) + convert<double>(grain.b) + convert<double>(grain.c)) / 3.0;
        const Vec3f origin = convert<float>(middle + distance * random.unit_vector());
        workload.rays.push_back({origin, convert<float>(middle - convert<double>(origin))});
    }
    return workload;
}

StructureWorkload plane_rays(std::size_t rays, std::uint64_t seed) {
    // With bounds from 2^-12 to 16 - 2^-12, the lattice's cells are 2^-12 wide, and every plane between cells is a
    // float.
    constexpr float cell = 0x1p-12f;
    auto mesh = std::make_shared<Mesh>();
    RandomSequence random(seed, 0);
    const auto corner = [&](int level, RandomSequence& from) {
        const auto plane = [&] {
            return std::clamp(std::ldexp(cast<float>(from.whole(0, 1 << level)), 4 - level), cell, 16 - cell);
        };
        const float x = plane(), y = plane();
        return Vec3f{x, y, plane()};
    };
    for (const float at : {cell, 16 - cell}) add(*mesh, {Vec3f(at), Vec3f(at), Vec3f(at)});
    for (int i = 0; i < 200; ++i) {
        const Vec3f a = corner(5, random);
        Vec3f b = corner(5, random), c = corner(5, random);
        const int axis = random.whole(0, 2);
        b[axis] = c[axis] = a[axis];
        add(*mesh, {a, a + (b - a) * 0.25f, a + (c - a) * 0.25f});
    }
    StructureWorkload workload{"in planes", "along the planes of cells and through their edges and corners",
                               std::make_shared<Scene>(mesh_scene(mesh, "planes"))};
    for (std::size_t i = 0; i < rays; ++i) {
        RandomSequence one(seed + 1, i);
        const auto part = [&] { return cast<float>(one.whole(-2, 2)); };
        const Vec3f origin = corner(6, one);
        const float x = part(), y = part();
        const Vec3f direction{x, y, part()};
        workload.rays.push_back({origin, direction == Vec3f(0) ? Vec3f(1, 0, 0) : direction});
    }
    return workload;
}

}  // namespace raylab::octrees

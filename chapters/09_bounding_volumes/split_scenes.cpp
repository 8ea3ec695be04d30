#include "split_scenes.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/sampling/sequence.h"
#include "raylab/scene/demo_meshes.h"
#include "raylab/scene/mesh/read_mesh.h"

namespace raylab::volumes {

namespace {

/// Adds a triangle that reaches from one point to the other and is this thin.
void add_straw(Mesh& mesh, const Vec3d& from, const Vec3d& to, const Vec3d& across) {
    add(mesh, {convert<float>(from - across), convert<float>(from + across), convert<float>(to)});
}

/// Adds wires between points of a sphere about the knot.
void add_wires(Mesh& mesh, int count, std::uint64_t seed) {
    constexpr double radius = 4, half_width = 0.01;
    for (int i = 0; i < count; ++i) {
        RandomSequence random(seed, static_cast<std::uint64_t>(i));
        const Vec3d from = random.unit_vector() * radius, to = random.unit_vector() * radius;
        add_straw(mesh, from, to, random.unit_vector_across(glm::normalize(to - from)) * half_width);
    }
}

Mesh straws(int count, std::uint64_t seed) {
    constexpr double half_length = 0.5, half_width = 0.005;
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        RandomSequence random(seed, static_cast<std::uint64_t>(i));
        const Vec3d middle = random.unit_vector() * random.between(0, 1), along = random.unit_vector();
        add_straw(mesh, middle - along * half_length, middle + along * half_length,
                  random.unit_vector_across(along) * half_width);
    }
    return mesh;
}

SplitScene with_rays(const std::string& name, Mesh mesh, const ChapterRun& run) {
    const auto scene = std::make_shared<const Scene>(mesh_scene(std::make_shared<Mesh>(std::move(mesh)), name));
    const auto rays = run.sized<std::size_t>(5'000, 400);
    return {name, camera_rays(name, scene, rays), incoherent_rays(name, scene, rays, run.seed)};
}

}  // namespace

std::vector<SplitScene> split_scenes(const ChapterRun& run) {
    const Mesh knot = trefoil_knot(0.35, run.sized(6, 4));
    Mesh wired = knot;
    add_wires(wired, run.sized(100, 10), run.seed);
    return {with_rays("knot", knot, run), with_rays("knot between wires", wired, run),
            with_rays("straws", straws(run.sized(5'000, 300), run.seed), run)};
}

std::vector<SplitScene> real_split_scenes(const ChapterRun& run) {
    std::vector<SplitScene> scenes;
    for (const std::string name : {"bunny", "elephant"})
        if (const auto file = demo_mesh(name)) scenes.push_back(with_rays(name, read_mesh(*file), run));
    return scenes;
}

}  // namespace raylab::volumes

#include "octree_methods.h"

#include "octree_kinds.h"

#include "raylab/geometry/generate.h"
#include "raylab/report/structure_question.h"
#include "raylab/sampling/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace raylab::octrees {

namespace {

// A point a short way on along the ray, so many times the length.
Vec3d along(const OctreeCube& cube, double length, const Vec3d& origin, const Vec3d& direction) {
    return origin + (exit_of(cube, origin, direction) + length / glm::length(direction)) * direction;
}

Vec3d fixed_step(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    return along(cube, 0.01 * Lattice::side, origin, direction);
}

Vec3d half_on(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    return along(cube, 0.5 * cube.side, origin, direction);
}

// Across the face, and wherever the rounded point is along the other axes.
Vec3d not_held(const OctreeCube& cube, double smallest, const Vec3d& origin, const Vec3d& direction) {
    const Vec3d exit = origin + exit_of(cube, origin, direction) * direction;
    Vec3d point = point_in_next_cell(cube, smallest, origin, direction);
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] >= cube.low[axis] && point[axis] < cube.low[axis] + cube.side) point[axis] = exit[axis];
    return point;
}

// A hundredth of the smallest cell on, rounded to floats at each step.
Vec3d small_step(const OctreeCube& cube, double smallest, const Vec3d& origin, const Vec3d& direction) {
    const Vec3f o = convert<float>(origin), d = convert<float>(direction);
    const float t = cast<float>(exit_of(cube, convert<double>(o), convert<double>(d)));
    const float on = cast<float>(0.01 * smallest) / glm::length(d);
    return convert<double>(o + (t + on) * d);
}

void add_square(Mesh& mesh, const Vec3f& corner, const Vec3f& u, const Vec3f& v) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3f& p : {corner, corner + u, corner + u + v, corner + v}) mesh.vertices.push_back(p);
    mesh.faces.push_back({first, first + 1, first + 2});
    mesh.faces.push_back({first, first + 2, first + 3});
}

// What a structure costs on the hall's rays.
std::vector<std::string> cost_row(const StructureMethod& method, const Scene& scene, const StructureWorkload& rays) {
    const auto structure = method.make(scene);
    Traversal traversal;
    answers_of(*structure, rays, traversal);
    const auto each = [&](std::uint64_t count) { return fmt::format("{:.1f}", static_cast<double>(count) / static_cast<double>(rays.rays.size())); };
    std::size_t leaves = 0, references = 0, triangles = 0;
    for (const auto& node : structure->outline().nodes) {
        leaves += node.children.empty() ? 1 : 0;
        references += node.primitives.size();
    }
    for (const Object& object : scene.objects) triangles += std::get<std::shared_ptr<const Mesh>>(object.shape)->faces.size();
    const auto a_triangle = [&](std::size_t count) { return fmt::format("{:.1f}", static_cast<double>(count) / static_cast<double>(triangles)); };
    return {method.name, std::to_string(leaves), a_triangle(references), each(traversal.primitive_tests), each(traversal.steps)};
}

std::vector<std::vector<std::string>> cost_rows(const std::vector<StructureMethod>& methods, const ChapterRun& run) {
    const auto scene = hall(run.sized(5, 4));
    const auto rays = camera_rays("hall", scene, run.sized<std::size_t>(20'000, 2'000));
    std::vector<std::vector<std::string>> rows;
    for (const auto& method : methods) rows.push_back(cost_row(method, *scene, rays));
    return rows;
}

}  // namespace

std::vector<StructureMethod> exact_ways() { return structure_methods({"octree", "octree_hash", "octree_seads"}); }

std::vector<StructureMethod> ways(const ChapterRun& run) {
    const bool yours = run.slot == ChapterRun::Slot::yours;
    std::vector<StructureMethod> methods{
        textbook("half a cell along the ray", "double", half_on), textbook("a fixed step along the ray", "double", fixed_step),
        textbook("a small step along the ray", "float", small_step),
        textbook("beyond the face, not held", "double", not_held),
        textbook("ends at any hit", "double", point_in_next_cell, End::at_first_hit),
        textbook(yours ? "yours" : "beyond the face", "double", point_in_next_cell)};
    for (auto& method : exact_ways()) methods.push_back(std::move(method));
    return methods;
}

StructureMethod way(const std::string& name, const ChapterRun& run) {
    const auto all = ways(run);
    return *std::ranges::find(all, name, &StructureMethod::name);
}

std::shared_ptr<const Scene> hall(int levels) {
    Mesh room = trefoil_knot(0.35, levels);
    for (Vec3f& v : room.vertices) v = v * 0.25f + Vec3f(-3, 1.2f, -3);
    constexpr float half = 6, height = 6;
    add_square(room, {-half, 0, -half}, {0, 0, 2 * half}, {2 * half, 0, 0});
    add_square(room, {-half, 0, -half}, {2 * half, 0, 0}, {0, height, 0});
    add_square(room, {-half, 0, -half}, {0, height, 0}, {0, 0, 2 * half});
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
        for (const Vec3f& corner : {a, a + within(size), a + within(size)}) mesh->vertices.push_back(corner);
        mesh->faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    StructureWorkload workload{distance < 10 ? "dust" : "dust from afar", "at grains, which are much smaller than the way to them",
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
    // Spanned from 2^-12 to 16 - 2^-12, the lattice's cells are 2^-12 wide, and every plane between cells is a float.
    constexpr float cell = 0x1p-12f;
    auto mesh = std::make_shared<Mesh>();
    RandomSequence random(seed, 0);
    const auto corner = [&](int level, RandomSequence& from) {
        const auto plane = [&] { return std::clamp(std::ldexp(cast<float>(from.whole(0, 1 << level)), 4 - level), cell, 16 - cell); };
        const float x = plane(), y = plane();
        return Vec3f{x, y, plane()};
    };
    const auto add = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        const auto first = static_cast<std::uint32_t>(mesh->vertices.size());
        mesh->vertices.insert(mesh->vertices.end(), {a, b, c});
        mesh->faces.push_back({first, first + 1, first + 2});
    };
    for (const float at : {cell, 16 - cell}) add(Vec3f(at), Vec3f(at), Vec3f(at));
    for (int i = 0; i < 200; ++i) {
        const Vec3f a = corner(5, random);
        Vec3f b = corner(5, random), c = corner(5, random);
        const int axis = random.whole(0, 2);
        b[axis] = c[axis] = a[axis];
        add(a, a + (b - a) * 0.25f, a + (c - a) * 0.25f);
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

Experiment measure_octrees(const ChapterRun& run) {
    const auto rays = run.sized<std::size_t>(10'000, 200);
    const auto scene = hall(run.sized(5, 4));
    const std::vector workloads{camera_rays("hall", scene, rays), incoherent_rays("hall", scene, rays, run.seed),
                                dust_rays(2, rays, run.seed), dust_rays(far_away, rays, run.seed), plane_rays(rays, run.seed)};
    Experiment experiment = measure_structures(ways(run), workloads, {.repeats = run.sized(5, 3), .shortest = run.sized(0.002, 0.0002)});
    experiment.question = "octree_next_cell";
    experiment.title = "Where does a ray go on?";
    return experiment;
}

std::vector<std::string> leaf_header() { return {"a cell is a leaf", "leaves", "references a triangle", "tests a ray", "steps a ray"}; }

std::vector<std::vector<std::string>> leaf_rows(const ChapterRun& run) {
    using Cut = OctreeLimits::Cut;
    using Assign = OctreeLimits::Assign;
    return cost_rows({octree_by_points("with 1, or 5 cuts deep", {.few = 1, .depth = 5, .cut = Cut::always}),
                      octree_by_points("with 1, or 7 cuts deep", {.few = 1, .depth = 7, .cut = Cut::always}),
                      octree_by_points("with 8, or 7 cuts deep", {.few = 8, .depth = 7, .cut = Cut::always}),
                      octree_by_points("with 8, or where cutting does not pay", {}),
                      octree_by_points("the same, filled by boxes", {.assign = Assign::by_box}),
                      octree_by_points("with 1, or where cutting does not pay", {.few = 1}),
                      octree_by_points("with 32, or where cutting does not pay", {.few = 32})}, run);
}

std::vector<std::string> way_header() {
    auto header = leaf_header();
    header[0] = "the next cell";
    return header;
}

std::vector<std::vector<std::string>> way_rows(const ChapterRun& run) {
    const auto seads = [](std::uint32_t most, int bits) { return OctreeLimits{.few = 4, .seads = {.most = most, .bits = bits}}; };
    return cost_rows({octree_by_points("by a point, up and down", {}), octree_by_names("by name", {}),
                      octree_by_blocks("by 3D-DDA, blocks of 2 x 2 x 2", {}),
                      octree_by_blocks("... and of 4 x 4 x 4 in its leaves", seads(64, 2)),
                      octree_by_blocks("... and of 8 x 8 x 8", seads(512, 3)),
                      octree_by_blocks("... and of 16 x 16 x 16", seads(4096, 4))}, run);
}

}  // namespace raylab::octrees

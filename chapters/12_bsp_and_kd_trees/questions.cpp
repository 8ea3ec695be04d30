#include "questions.h"

#include "weak_tree.h"

#include "raylab/accelerator/split_tree/kd_tree.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/sampling/sequence.h"

namespace raylab::split {

namespace {

StructureMethod tree(const std::string& name, const PlaneRule& rule) {
    return {.name = name, .make = [rule](const Scene& scene) { return std::make_unique<KdTree>(scene, rule); }};
}

std::shared_ptr<const Scene> scene_of(const std::vector<Triangle>& triangles, const std::string& name) {
    return std::make_shared<const Scene>(mesh_scene(mesh_of(triangles), name));
}

struct Plane {
    int axis;
    float at;
};

// The planes of the kd-tree, taken from its outline.
std::vector<Plane> planes_of(const Scene& scene) {
    const Outline outline = KdTree(scene).outline();
    std::vector<Plane> planes;
    for (const Outline::Node& node : outline.nodes) {
        if (node.children.empty()) continue;
        const Box &whole = std::get<Box>(node.bound), &below = std::get<Box>(outline.nodes[node.children[0]].bound);
        for (int axis = 0; axis < 3; ++axis)
            if (below.max[axis] != whole.max[axis]) planes.push_back({axis, below.max[axis]});
    }
    return planes;
}

}  // namespace

std::vector<StructureMethod> strong_trees(const SahCosts& costs) {
    return {tree("bsp, spatial median", spatial_median()), tree("bsp, object median", object_median()),
            tree("kd, surface area heuristic", surface_area_heuristic(costs))};
}

std::vector<StructureMethod> weak_trees() {
    std::vector<StructureMethod> methods;
    for (const Mistake mistake :
         {Mistake::rounding, Mistake::in_doubles, Mistake::only_inside, Mistake::first_found, Mistake::nan_goes_beyond})
        methods.push_back(
            {.name = words(mistake),
             .number = mistake == Mistake::in_doubles ? "double" : "float",
             .make = [mistake](const Scene& scene) { return std::make_unique<WeakTree>(scene, mistake); }});
    return methods;
}

StructureWorkload straw(std::size_t rays, std::uint64_t seed) {
    std::vector<Triangle> triangles;
    for (std::uint64_t i = 0; i < 1'000; ++i) {
        RandomSequence random(seed, i);
        const Vec3d middle = random.in_cube(), along = random.unit_vector(), across = random.unit_vector();
        triangles.push_back({convert<float>(middle - along * 0.5), convert<float>(middle + along * 0.5),
                             convert<float>(middle + across * 0.02)});
    }
    auto workload = incoherent_rays("straw", scene_of(triangles, "straw"), rays, seed);
    workload.about = "long thin triangles: each lies in many cells, and is hit far from where it is first hit";
    return workload;
}

StructureWorkload balls(std::size_t rays, std::uint64_t seed) {
    Scene scene;
    scene.source = "balls";
    for (std::uint64_t i = 0; i < 200; ++i) {
        RandomSequence random(seed, i);
        const Vec3f center = convert<float>(random.in_cube());
        const double size = random.next();
        scene.objects.push_back({.shape = Sphere{center, cast<float>(0.03 + 0.4 * size * size * size)}});
    }
    look_at_all(scene);
    return incoherent_rays("balls", std::make_shared<const Scene>(std::move(scene)), rays, seed);
}

StructureWorkload in_planes(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                            std::uint64_t seed) {
    StructureWorkload workload{name + ": in planes", "from and along the planes that cut the cells", scene};
    const auto planes = planes_of(*scene);
    const Box box =
        KdTree(*scene).outline().nodes.empty() ? Box{} : std::get<Box>(KdTree(*scene).outline().nodes[0].bound);
    const Vec3d half = (convert<double>(box.max) - convert<double>(box.min)) * 0.5;
    for (std::uint64_t i = 0; i < rays; ++i) {
        RandomSequence random(seed, i);
        Ray ray{.origin = convert<float>(box.center() + half * random.in_cube() * 1.5),
                .direction = convert<float>(random.unit_vector())};
        for (int k = 0; k < 2; ++k) {
            const Plane& plane = planes[static_cast<std::size_t>(random.whole(0, static_cast<int>(planes.size()) - 1))];
            ray.origin[plane.axis] = plane.at;
            if (random.next() < 0.5) ray.direction[plane.axis] = random.next() < 0.5 ? 0.0f : -0.0f;
        }
        if (ray.direction != Vec3f(0)) workload.rays.push_back(ray);
    }
    return workload;
}

std::shared_ptr<const Scene> tiles() {
    std::vector<Triangle> triangles;
    constexpr int side = 12;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const auto square = [&](const auto& at) {
                triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
                triangles.push_back({at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)});
            };
            square([](int x, int y) { return Vec3f(cast<float>(x), 0, cast<float>(y)); });
            square([](int x, int y) { return Vec3f(cast<float>(x), cast<float>(y), side / 2); });
        }
    }
    return scene_of(triangles, "tiles");
}

std::shared_ptr<const Scene> bumps(const ChapterRun& run) {
    return std::make_shared<const Scene>(
        mesh_scene(std::make_shared<const Mesh>(bumpy_sphere(run.sized(4, 3))), "bumps"));
}

Experiment measure_trees(const ChapterRun& run) {
    auto methods = strong_trees();
    if (run.is_yours("sah_cost")) methods.back().name = "yours";  // the student's cost chooses its planes
    for (StructureMethod& weak : weak_trees()) methods.push_back(std::move(weak));
    methods.push_back(structure_method("bvh"));
    const std::size_t rays = run.sized<std::size_t>(10'000, 200);
    const auto ball = bumps(run);
    const std::vector<StructureWorkload> workloads{
        camera_rays("bumps", ball, rays), incoherent_rays("bumps", ball, rays, run.seed),
        in_planes("bumps", ball, rays, run.seed), straw(rays, run.seed), in_planes("tiles", tiles(), rays, run.seed)};
    Experiment experiment =
        measure_structures(methods, workloads, {.repeats = run.sized(5, 1), .shortest = run.sized(0.002, 0.0)});
    experiment.question = "split_tree";
    experiment.title = "Which hit is the nearest? Trees of planes";
    return experiment;
}

}  // namespace raylab::split

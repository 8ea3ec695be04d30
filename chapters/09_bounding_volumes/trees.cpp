#include "trees.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/experiment/structure/structure_question.h"
#include "raylab/image/draw.h"
#include "raylab/sampling/sequence.h"
#include "raylab/tracer/picture/eye_picture.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::volumes {

namespace {

// Heights from 1 to 3 without an obvious pattern.
int height_of(int x, int y) { return 1 + (x * x * 7 + y * 5 + x * y * 3) % 3; }

void add_tower(Mesh& mesh, float x, float y, float height) {
    const Vec3f east{1, 0, 0}, north{0, 1, 0}, up{0, 0, height}, foot{x, y, 0};
    add_parallelogram(mesh, foot, east, up);
    add_parallelogram(mesh, foot + east, north, up);
    add_parallelogram(mesh, foot + north + east, -east, up);
    add_parallelogram(mesh, foot + north, -north, up);
    add_parallelogram(mesh, foot + up, east, north);
}

std::size_t depth(const Outline& outline, std::uint32_t node = 0) {
    std::size_t below = 0;
    for (const std::uint32_t child : outline.nodes[node].children) below = std::max(below, depth(outline, child));
    return 1 + below;
}

std::string per_ray(std::uint64_t count, const StructureWorkload& workload) {
    return fmt::format("{:.1f}", static_cast<double>(count) / static_cast<double>(workload.rays.size()));
}

}  // namespace

std::vector<StructureMethod> trees() { return structure_methods({"bvh_sphere", "bvh", "bvh_obb", "bvh8"}); }

std::shared_ptr<const Scene> knot(int levels) {
    static constexpr double tube = 0.35;
    return std::make_shared<Scene>(mesh_scene(std::make_shared<Mesh>(trefoil_knot(tube, levels)), "knot"));
}

StructureWorkload city_rays(int along_side) {
    constexpr int blocks = 12;
    constexpr float width = blocks + 4, above = 20;
    auto mesh = std::make_shared<Mesh>();
    for (int x = 0; x < blocks; ++x)
        for (int y = 0; y < blocks; ++y)
            add_tower(*mesh, static_cast<float>(x), static_cast<float>(y), static_cast<float>(height_of(x, y)));
    const auto scene = std::make_shared<Scene>(mesh_scene(mesh, "city"));
    StructureWorkload workload{"city from above",
                               "straight down on towers of whole metres, many along "
                               "their walls",
                               scene};
    const float step = width / static_cast<float>(along_side);
    for (int j = 0; j < along_side; ++j)
        for (int i = 0; i < along_side; ++i)
            workload.rays.push_back(
                {{-2 + step * static_cast<float>(i), 14 - step * static_cast<float>(j), above}, {0, 0, -1}});
    return workload;
}

StructureWorkload corner_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                              std::uint64_t seed) {
    const Mesh& mesh = *std::get<std::shared_ptr<const Mesh>>(scene->objects.front().shape);
    StructureWorkload workload{name, "at the corners of triangles, but for the rounding of their direction", scene};
    for (std::size_t i = 0; i < rays; ++i) {
        RandomSequence random(seed, i);
        const Vec3f corner =
            mesh.vertices[static_cast<std::size_t>(random.whole(0, static_cast<int>(mesh.vertices.size()) - 1))];
        const Vec3f origin = corner + convert<float>(random.unit_vector() * 9.0);
        workload.rays.push_back({origin, corner - origin});
    }
    return workload;
}

Image city_through(const StructureMethod& method, int along_side) {
    const auto workload = city_rays(along_side);
    Traversal traversal;
    const auto given = answers_of(*method.make(*workload.scene), workload, traversal), truth = true_answers(workload);
    Image image(along_side, along_side);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const bool right =
            given[i].has_value() == truth[i].has_value() && (!truth[i] || given[i]->primitive == truth[i]->primitive);
        const double grey = truth[i] ? 0.25 + 0.2 * (20 - truth[i]->t) : 0.08;
        const auto across = static_cast<std::size_t>(along_side);
        image.at(static_cast<int>(i % across), static_cast<int>(i / across)) =
            to_pixel(right ? Color(grey) : Color{0.85, 0.1, 0.05});
    }
    return enlarged(image, 640 / along_side);
}

Experiment measure_hierarchies(const ChapterRun& run) {
    const auto rays = run.sized<std::size_t>(8'000, 150);
    const auto tube = knot(run.sized(5, 4));
    auto workloads = ray_workloads("knot", tube, rays, run.seed);
    workloads.push_back(corner_rays("knot: at corners", tube, rays, run.seed));
    workloads.push_back(city_rays(run.sized(128, 16)));
    auto methods = weak_trees();
    methods.push_back(textbook_tree(run.name_of("nearest_in_tree", "boxes: textbook")));
    for (auto& method : trees()) methods.push_back(method);
    for (auto& method : cuts())
        if (method.name != "by cost, 16 bins") methods.push_back(method);  // this one is the bvh
    Experiment experiment =
        measure_structures(methods, workloads, {.repeats = 3, .shortest = run.sized(0.002, 0.0002)});
    experiment.question = "hierarchy";
    experiment.title = "Can most tests be skipped?";
    return experiment;
}

std::vector<std::string> counts_header() {
    return {"tree", "rays", "primitive tests", "bounds tested", "nodes visited", "bytes a primitive"};
}

std::vector<std::vector<std::string>> counts_rows(const std::vector<StructureMethod>& methods, const ChapterRun& run) {
    const auto scene = knot(run.sized(6, 4));
    const auto rays = run.sized<std::size_t>(20'000, 1'000);
    const std::vector workloads{camera_rays("knot", scene, rays), incoherent_rays("knot", scene, rays, run.seed)};
    std::vector<std::vector<std::string>> rows;
    for (const StructureMethod& method : methods) {
        const auto structure = method.make(*scene);
        for (const StructureWorkload& workload : workloads) {
            Traversal traversal;
            answers_of(*structure, workload, traversal);
            const auto triangles =
                static_cast<double>(std::get<std::shared_ptr<const Mesh>>(scene->objects[0].shape)->faces.size());
            rows.push_back({method.name, workload.name, per_ray(traversal.primitive_tests, workload),
                            per_ray(traversal.box_tests, workload), per_ray(traversal.steps, workload),
                            fmt::format("{:.0f}", static_cast<double>(structure->bytes()) / triangles)});
        }
    }
    return rows;
}

std::vector<std::string> depth_header() {
    return {"scene", "triangles a leaf", "depth", "bounds tested", "primitive tests"};
}

std::vector<std::vector<std::string>> depth_rows(const ChapterRun& run) {
    const auto tube = camera_rays("knot", knot(run.sized(6, 4)), run.sized<std::size_t>(20'000, 1'000));
    std::vector<std::vector<std::string>> rows;
    for (const StructureWorkload& workload : {tube, city_rays(run.sized(128, 32))}) {
        for (const std::size_t leaf : {1, 4, 16, 64}) {
            const auto tree = down_to(leaf).make(*workload.scene);
            Traversal traversal;
            answers_of(*tree, workload, traversal);
            rows.push_back({workload.name, std::to_string(leaf), std::to_string(depth(tree->outline())),
                            per_ray(traversal.box_tests, workload), per_ray(traversal.primitive_tests, workload)});
        }
    }
    return rows;
}

}  // namespace raylab::volumes

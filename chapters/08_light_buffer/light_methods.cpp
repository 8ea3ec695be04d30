#include "light_methods.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/textbook/textbook_light_buffer.h"
#include "raylab/report/table.h"
#include "raylab/sampling/sequence.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/shading/ray_start.h"

#include <fmt/format.h>

namespace raylab::lantern {

namespace {

std::vector<int> resolutions(const ChapterRun& run) { return run.sized<std::vector<int>>({8, 32, 128, 512}, {8, 64}); }

std::string words(int resolution) { return fmt::format("{0} x {0}", resolution); }

struct Counts {
    double tests, wrong;  // tests for each shadow ray; wrong answers in ppm
    std::size_t bytes;
};

Counts counts(const StructureMethod& method, const StructureWorkload& workload, const StructureAnswers& truth) {
    const auto structure = method.make(*workload.scene);
    Traversal traversal;
    const auto answers = answers_of(*structure, workload, traversal);
    const double rays = static_cast<double>(workload.rays.size());
    return {static_cast<double>(traversal.primitive_tests) / rays,
            1e6 * static_cast<double>(wrong_answers(answers, truth, workload.question)) / rays, structure->bytes()};
}

StructureWorkload lantern_shadow_rays(const ChapterRun& run, std::size_t rays) {
    auto workload = shadow_rays("lantern", std::make_shared<const Scene>(read_scene(run.scene)), rays, run.seed);
    workload.name = "the lantern";
    return workload;
}

std::string name_of(Listing listing, const ChapterRun& run) {
    if (listing == Listing::rectangles) return "rectangles";
    if (listing == Listing::centers) return "centres";
    return run.name_of("light_cell", "conservative");
}

}  // namespace

StructureMethod light_buffer(Listing listing, int resolution, const ChapterRun& run) {
    return {name_of(listing, run), "exact", [=](const Scene& scene) -> std::unique_ptr<Accelerator> {
                return std::make_unique<LightBuffered>(make_accelerator("list", scene), scene,
                                                       LightBufferOptions{resolution, listing});
            }};
}

StructureMethod textbook_light_buffer(int resolution, const ChapterRun& run) {
    const bool is_asked = run.is_yours("light_through_list") || run.is_yours("listed_cells");
    return {is_asked ? "yours" : "textbook", "double",
            [=](const Scene& scene) { return std::make_unique<TextbookLightBuffer>(scene, resolution); }};
}

std::vector<LightMethod> light_methods(const ChapterRun& run) {
    std::vector<LightMethod> methods{{structure_method("list")}, {structure_method("bvh")}, {structure_method("bvh8")}};
    for (const Listing listing : {Listing::conservative, Listing::rectangles, Listing::centers})
        for (const int resolution : resolutions(run))
            methods.push_back({light_buffer(listing, resolution, run), words(resolution)});
    const int resolution = resolutions(run)[1];  // one is enough to see what it does without bounds of errors
    methods.push_back({textbook_light_buffer(resolution, run), words(resolution)});
    return methods;
}

Ray shadow_ray_from(const Vec3d& point, const Vec3d& light) {
    const Vec3f origin = convert<float>(point);
    const Vec3d way = light - convert<double>(origin);
    const double distance = glm::length(way);
    return {origin, convert<float>(way / distance), {0, cast<float>(length_of_shadow_ray(distance))}};
}

StructureWorkload among_triangles(const std::string& name, std::size_t triangles, double size, std::size_t rays,
                                  std::uint64_t seed) {
    auto scene = std::make_shared<Scene>();
    for (std::size_t i = 0; i < triangles; ++i) {
        RandomSequence random(seed, i);
        const Vec3d at = random.in_cube();
        const auto corner = [&] { return convert<float>(at + random.in_cube() * (size / 2)); };
        scene->objects.push_back({.shape = Triangle{corner(), corner(), corner()}});
    }
    scene->lights = {{.kind = PointLight{{0, 0, 0}}}};
    StructureWorkload result{name,
                             fmt::format("a light among {} triangles of size {:g} in a cube of 2", triangles, size),
                             scene, RayQuestion::any};
    for (std::size_t i = 0; i < rays; ++i) {
        RandomSequence random(seed + 1, i);
        result.rays.push_back(shadow_ray_from(2.0 * random.in_cube(), {0, 0, 0}));
    }
    return result;
}

std::vector<StructureWorkload> light_workloads(const ChapterRun& run) {
    const auto rays = run.sized<std::size_t>(4'000, 400);
    const auto mesh = std::make_shared<const Mesh>(bumpy_sphere(run.sized(4, 2)));
    auto bumpy = shadow_rays("", std::make_shared<const Scene>(mesh_scene(mesh, "bumpy ball")), rays, run.seed);
    bumpy.name = "a mesh, the light far away";
    return {lantern_shadow_rays(run, rays), among_triangles("among small triangles", 500, 0.05, rays, run.seed),
            among_triangles("among large triangles", 500, 0.5, rays, run.seed), bumpy};
}

Experiment measure_light_buffers(const ChapterRun& run) {
    Experiment experiment{.question = "light_buffer",
                          .title = "Can shadows be cheaper?",
                          .error_axis = "wrong answers [ppm]",
                          .rows = {}};
    for (const StructureWorkload& workload : light_workloads(run)) {
        const auto truth = true_answers(workload);
        for (const auto& [method, knob] : light_methods(run)) {
            experiment.rows.push_back(measure_structure(method, workload, truth, {.repeats = 3}));
            experiment.rows.back().knob = knob;
        }
    }
    return experiment;
}

std::vector<std::string> resolution_header() {
    return {"cells", "kilobytes", "tests a shadow ray", "... rectangles", "... centres", "wrong by centres [ppm]"};
}

std::vector<std::vector<std::string>> resolution_rows(const ChapterRun& run) {
    const auto workload = lantern_shadow_rays(run, run.sized<std::size_t>(20'000, 2'000));
    const auto truth = true_answers(workload);
    const auto none = counts(structure_method("list"), workload, truth),
               tree = counts(structure_method("bvh"), workload, truth);
    std::vector<std::vector<std::string>> rows{
        {"none: a list", "", fmt::format("{:.2f}", none.tests), "", "", ""},
        {"none: a tree", "", fmt::format("{:.2f}, and boxes", tree.tests), "", "", ""}};
    for (const int resolution : run.sized<std::vector<int>>({4, 16, 64, 256}, {4, 64})) {
        const auto of = [&](Listing listing) {
            return counts(light_buffer(listing, resolution, run), workload, truth);
        };
        const auto right = of(Listing::conservative), loose = of(Listing::rectangles), weak = of(Listing::centers);
        rows.push_back({"6 x " + words(resolution), fmt::format("{:.0f}", static_cast<double>(right.bytes) / 1e3),
                        fmt::format("{:.2f}", right.tests), fmt::format("{:.2f}", loose.tests),
                        fmt::format("{:.2f}", weak.tests), fmt::format("{:.0f}", weak.wrong)});
    }
    return rows;
}

CurveChart distance_chart(const ChapterRun& run) {
    CurveChart chart{.title = "A light far away uses few cells",
                     .x_label = "cells along the cube's edge",
                     .y_label = "primitive tests a shadow ray",
                     .x_axis = AxisKind::logarithmic,
                     .y_axis = AxisKind::logarithmic,
                     .curves = {}};
    for (const double distance : {0.0, 4.0, 16.0, 64.0}) {
        auto workload = among_triangles("", 500, 0.1, run.sized<std::size_t>(4'000, 500), run.seed);
        auto scene = std::make_shared<Scene>(*workload.scene);
        const Vec3d light{0.1 * distance, distance, 0.2 * distance};
        scene->lights[0].kind = PointLight{light};
        for (Ray& ray : workload.rays) ray = shadow_ray_from(convert<double>(ray.origin) * 0.5, light);
        workload.scene = scene;
        const StructureAnswers truth = true_answers(workload);
        Curve curve{.name = distance == 0 ? "in their midst" : fmt::format("{:g} m away", distance), .x = {}, .y = {}};
        for (int resolution = 2; resolution <= run.sized(256, 64); resolution *= 2) {
            curve.x.push_back(resolution);
            curve.y.push_back(counts(light_buffer(Listing::conservative, resolution, run), workload, truth).tests);
        }
        chart.curves.push_back(std::move(curve));
    }
    return chart;
}

}  // namespace raylab::lantern

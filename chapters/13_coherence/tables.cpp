#include "tables.h"

#include "first_hit.h"

#include "raylab/accelerator/item_buffer/item_buffer.h"
#include "raylab/experiment/structure/structure_question.h"

#include <fmt/format.h>

#include <memory>

namespace raylab::coherence {

namespace {

std::string per(double what, std::size_t rays) { return fmt::format("{:.2f}", what / static_cast<double>(rays)); }

Traversal counted(const Accelerator& structure, const StructureWorkload& workload) {
    Traversal traversal;
    answers_of(structure, workload, traversal);
    return traversal;
}

struct Stops {
    Traversal traversal;
    std::size_t stopped = 0, remembered = 0;  // remembered: those that the previous ray's blocker stops
};

enum class Memory { none, of_the_last };

Stops trace_shadow_rays(const Accelerator& structure, const std::vector<Ray>& rays, Memory memory) {
    Stops stops;
    if (memory == Memory::of_the_last) stops.traversal.toward(0);
    for (const Ray& ray : rays) {
        const auto before = stops.traversal.primitive_tests + stops.traversal.box_tests;
        if (!structure.occluded(ray, stops.traversal)) continue;
        ++stops.stopped;
        stops.remembered += stops.traversal.primitive_tests + stops.traversal.box_tests == before + 1;
    }
    return stops;
}

std::vector<std::string> memory_row(const std::string& name, const StructureWorkload& workload, Memory memory) {
    const Stops stops = trace_shadow_rays(*make_accelerator("bvh", *workload.scene), workload.rays, memory);
    const std::size_t rays = workload.rays.size();
    const auto share = [&](std::size_t part, std::size_t whole) {
        return fmt::format("{:.0f} %",
                           100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(1, whole)));
    };
    return {name,
            memory == Memory::none ? "nothing" : "the last blocker",
            share(stops.stopped, rays),
            memory == Memory::none ? "none" : share(stops.remembered, stops.stopped),
            per(static_cast<double>(stops.traversal.primitive_tests), rays),
            per(static_cast<double>(stops.traversal.box_tests), rays)};
}

}  // namespace

std::vector<std::string> saving_header() {
    return {"pixels",
            "items a pixel",
            "tests a ray, item buffer",
            "tests a ray, tree",
            "boxes a ray, tree",
            "primitives drawn for a ray"};
}

Rows saving_rows(const ChapterRun& run) {
    const auto scene = ball(run.sized(4, 2));
    const auto tree = make_accelerator("bvh", *scene);
    const double primitives =
        static_cast<double>(std::get<std::shared_ptr<const Mesh>>(scene->objects[0].shape)->faces.size());
    Rows rows;
    for (int side = 16; side <= run.sized(512, 64); side *= 2) {
        const auto workload = tiled_camera_rays("camera", scene, side);
        const std::size_t rays = workload.rays.size();
        const ItemBuffer buffer(*scene, camera_frame(scene->camera, {side, side}), *tree);
        double kept = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) kept += static_cast<double>(buffer.items(x, y).value_or(0));
        const Traversal with = counted(buffer, workload), without = counted(*tree, workload);
        rows.push_back({fmt::format("{} x {}", side, side), per(kept, rays),
                        per(static_cast<double>(with.primitive_tests), rays),
                        per(static_cast<double>(without.primitive_tests), rays),
                        per(static_cast<double>(without.box_tests), rays), per(primitives, rays)});
    }
    return rows;
}

CurveChart packet_chart(const ChapterRun& run) {
    const auto scene = ball(run.sized(4, 2));
    const auto tree = make_accelerator("bvh", *scene);
    Curve alone{.name = "alone"}, together{.name = "in packets"};
    for (int side = 16; side <= run.sized(1024, 64); side *= 2) {
        const auto workload = tiled_camera_rays("camera", scene, side);
        const double rays = static_cast<double>(workload.rays.size());
        Traversal packets;
        tree->closest_of(workload.rays, packets);
        for (Curve* curve : {&alone, &together}) curve->x.push_back(side);
        alone.y.push_back(static_cast<double>(counted(*tree, workload).box_tests) / rays);
        together.y.push_back(static_cast<double>(packets.box_tests) / rays);
    }
    return {.title = "The closer neighbours are, the longer they share their way",
            .x_label = "pixels a side",
            .y_label = "box tests a ray",
            .x_axis = AxisKind::logarithmic,
            .curves = {alone, together}};
}

std::vector<std::string> memory_header() {
    return {"scene", "remembered", "stopped", "... by what is remembered", "tests a shadow ray", "boxes a shadow ray"};
}

Rows memory_rows(const Scene& scene, const ChapterRun& run) {
    const std::size_t rays = run.sized<std::size_t>(40'000, 4'000);
    auto one_light = std::make_shared<Scene>(scene);
    one_light->lights.resize(1);
    Rows rows;
    using Named = std::pair<std::string, std::shared_ptr<const Scene>>;
    for (const auto& [name, lit] : {Named{"colonnade", one_light}, Named{"bumpy ball", ball(run.sized(4, 2))}}) {
        const StructureWorkload workload = shadow_rays(name, lit, rays, run.seed);
        for (const Memory memory : {Memory::none, Memory::of_the_last})
            rows.push_back(memory_row(name, workload, memory));
    }
    return rows;
}

}  // namespace raylab::coherence

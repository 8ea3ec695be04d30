#include "first_hit.h"

#include "z_buffer.h"

#include "raylab/accelerator/item_buffer/item_buffer.h"
#include "raylab/accelerator/ray_space/ray_space.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/structure/structure_question.h"

#include <cmath>
#include <utility>

namespace raylab::coherence {

namespace {

constexpr int tile = 8;

int pixels_a_side(const StructureWorkload& workload) {
    return static_cast<int>(std::lround(std::sqrt(static_cast<double>(workload.rays.size()))));
}

CameraFrame frame_of(const StructureWorkload& workload) {
    const int side = pixels_a_side(workload);
    return camera_frame(workload.scene->camera, {side, side}, workload.scene->source);
}

// Traces the workload's rays one after the other.
Method::Answer one_by_one(std::shared_ptr<const Accelerator> structure, const StructureWorkload& workload) {
    return [structure, &workload](Traversal& traversal) { return answers_of(*structure, workload, traversal); };
}

Method structure(const std::string& name) {
    return {name, "exact", [name](const StructureWorkload& workload) {
                return one_by_one(std::shared_ptr<const Accelerator>(make_accelerator(name, *workload.scene)),
                                  workload);
            }};
}

Method::Answer in_packets(const StructureWorkload& workload) {
    const std::shared_ptr<const Accelerator> tree = make_accelerator("bvh", *workload.scene);
    return [tree, &workload](Traversal& traversal) { return tree->closest_of(workload.rays, traversal); };
}

// A structure in front of another one, to which it refers.
template <class Front>
struct Before {
    std::unique_ptr<Accelerator> behind;
    Front front;

    template <class... Given>
    Before(const Scene& scene, const Given&... given)
        : behind(make_accelerator("bvh", scene)), front(scene, given..., *behind) {}
};

// Ray space, built for every second one of the rays.
Method::Answer by_ray_space(const StructureWorkload& workload) {
    std::vector<Ray> expected;
    for (std::size_t i = 0; i < workload.rays.size(); i += 2) expected.push_back(workload.rays[i]);
    const auto both = std::make_shared<Before<RaySpace>>(*workload.scene, expected);
    return one_by_one(std::shared_ptr<const Accelerator>(both, &both->front), workload);
}

// An item buffer is valid for one picture only, so drawing it is part of answering.
Method::Answer by_item_buffer(const StructureWorkload& workload) {
    const std::shared_ptr<const Accelerator> behind = make_accelerator("bvh", *workload.scene);
    return [behind, &workload](Traversal& traversal) {
        const ItemBuffer buffer(*workload.scene, frame_of(workload), *behind);
        return answers_of(buffer, workload, traversal);
    };
}

template <Real T>
Method::Answer by_z_buffer(const StructureWorkload& workload) {
    return [&workload](Traversal&) {
        const auto& mesh = *std::get<std::shared_ptr<const Mesh>>(workload.scene->objects[0].shape);
        const int side = pixels_a_side(workload), tiles = side / tile;
        const Items items = z_buffer<T>(mesh, frame_of(workload));
        Method::Answers answers;
        for (int i = 0; i < side * side; ++i) {
            const int in_tile = i % (tile * tile), number = i / (tile * tile);
            const int x = number % tiles * tile + in_tile % tile, y = number / tiles * tile + in_tile / tile;
            const auto& item = items[static_cast<std::size_t>(y * side + x)];
            answers.push_back(item ? std::optional(Hit{0, {0, *item}}) : std::nullopt);
        }
        return answers;
    };
}

// A z-buffer returns the triangle, and no exact t.
bool right(const Method& method, const std::optional<Hit>& given, const std::optional<Hit>& truth) {
    if (!given || !truth) return !given && !truth;
    return given->primitive == truth->primitive && (method.number != "exact" || given->t == truth->t);
}

Measurement measure_method(const Method& method, const StructureWorkload& workload, const StructureAnswers& truth,
                           const MeasureOptions& options) {
    const std::size_t rays = workload.rays.size();
    Measurement row{.method = method.name, .number = method.number, .workload = workload.name, .queries = rays};
    Method::Answer answer;
    row.prepare_nanoseconds =
        time_per_query(1, [&] { answer = method.prepare(workload); }, {.repeats = 1, .shortest = 0});
    Traversal traversal;
    const auto answers = answer(traversal);
    row.nanoseconds = time_per_query(
        rays,
        [&] {
            Traversal uncounted;
            answer(uncounted);
        },
        options);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays; ++i) wrong += !right(method, answers[i], truth[i]);
    const double n = static_cast<double>(rays);
    row.error = 1e6 * static_cast<double>(wrong) / n;
    row.error_bound = 1e6 * 3 / n;
    row.counts = {{"primitive tests", static_cast<double>(traversal.primitive_tests) / n},
                  {"box tests", static_cast<double>(traversal.box_tests) / n},
                  {"steps", static_cast<double>(traversal.steps) / n}};
    return row;
}

}  // namespace

StructureWorkload tiled_camera_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, int side) {
    StructureWorkload result{name, "neighbours go almost the same way", scene};
    const CameraFrame frame = camera_frame(scene->camera, {side, side}, scene->source);
    for (int y = 0; y < side; y += tile)
        for (int x = 0; x < side; x += tile)
            for (int i = 0; i < tile * tile; ++i)
                result.rays.push_back(eye_ray(frame, x + i % tile + 0.5, y + i / tile + 0.5));
    return result;
}

std::shared_ptr<const Scene> ball(int levels) {
    return std::make_shared<const Scene>(mesh_scene(std::make_shared<const Mesh>(bumpy_sphere(levels)), "bumpy ball"));
}

std::shared_ptr<const Scene> far_ball(int levels) {
    Scene scene = *ball(levels);
    scene.camera.position = scene.camera.target + (scene.camera.position - scene.camera.target) * 4000.0;
    scene.camera.projection = Perspective{0.01};
    return std::make_shared<const Scene>(std::move(scene));
}

std::vector<Method> methods() {
    using enum Method::Of;
    return {structure("bvh"),
            {"bvh in packets", "exact", in_packets},
            {"ray space", "exact", by_ray_space},
            {"item buffer", "exact", by_item_buffer, camera_rays},
            {"z-buffer", "double", by_z_buffer<double>, camera_rays},
            {"z-buffer", "float", by_z_buffer<float>, camera_rays}};
}

Experiment measure_first_hit(const ChapterRun& run) {
    const auto scene = ball(run.sized(4, 2));
    const int side = run.sized(128, 32);
    const auto rays = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    const std::vector<StructureWorkload> workloads{
        tiled_camera_rays("camera", scene, side),
        tiled_camera_rays("camera, far away", far_ball(run.sized(4, 2)), side),
        bounce_rays("ball", scene, rays, run.seed), incoherent_rays("ball", scene, rays, run.seed)};
    Experiment experiment{"first_hit", "What do neighbouring rays hit first?", "wrong answers [ppm]", {}};
    const MeasureOptions options{.repeats = run.sized(5, 1), .shortest = run.sized(0.01, 0.0)};
    for (const StructureWorkload& workload : workloads) {
        const StructureAnswers truth = true_answers(workload);
        const bool of_camera = workload.name.starts_with("camera");
        for (Method method : methods()) {
            if (!of_camera && method.of != Method::Of::all_rays) continue;
            const bool has_slot = method.name == "z-buffer" && method.number == "double";
            if (has_slot && run.is_yours("drawn_depth")) method.name = "yours";
            experiment.rows.push_back(measure_method(method, workload, truth, options));
        }
    }
    return experiment;
}

}  // namespace raylab::coherence

#include "box_tests.h"

#include "four_boxes.h"
#include "slab_ray.h"

#include "raylab/accelerator/bvh/ray_box.h"
#include "raylab/geometry/box_entry.h"
#include "raylab/report/table.h"

namespace raylab::volumes {

namespace {

template <class Test>
BoxMethod method(const std::string& name, const std::string& number, const std::string& source, const Test& test) {
    return {name,
            number,
            source,
            {},
            [test](const std::any&, std::span<const Box> boxes, std::span<const BoxQuery> queries,
                   std::span<std::optional<double>> answers) {
                for (std::size_t i = 0; i < queries.size(); ++i)
                    answers[i] = test(queries[i].ray, boxes[queries[i].box]);
            }};
}

std::optional<double> finite(double entry) {
    return entry < std::numeric_limits<double>::infinity() ? std::optional(entry) : std::nullopt;
}

template <class PreparedRay>
std::optional<double> by_slabs(const Ray& ray, const Box& box) {
    return finite(PreparedRay(ray).entry(box));
}

// The tree's test, of two boxes at once; the second one is empty.
std::optional<double> in_pairs(const Ray& ray, const Box& box) {
    constexpr float none = std::numeric_limits<float>::infinity();
    return finite(BoxRay(ray).entries({{{box.min.x, none},
                                        {box.min.y, none},
                                        {box.min.z, none},
                                        {box.max.x, -none},
                                        {box.max.y, -none},
                                        {box.max.z, -none}}})[0]);
}

std::optional<double> in_fours(const Ray& ray, const Box& box) {
    FourBoxes boxes = FourBoxes::empty();
    boxes.set(0, box);
    return (FourBoxesRay(ray).rays_hitting(boxes) & 1) != 0 ? std::optional<double>(ray.range.min) : std::nullopt;
}

std::optional<double> by_slot(const Ray& ray, const Box& box) {
    return box_entry(in<double>(ray), convert<double>(box.min), convert<double>(box.max));
}

}  // namespace

std::vector<BoxMethod> box_methods(const ChapterRun& run) {
    const std::string williams = "Williams, Barrus, Morley and Shirley, An Efficient and Robust Ray-Box "
                                 "Intersection Algorithm, JGT 10(1), 2005";
    const std::string ize = "Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013";
    return {method("fmin and fmax", "float", "a frequent mistake", by_slabs<FminFmax>),
            method("std::min and max", "float",
                   "Barnes, Fast, Branchless Ray/Bounding Box "
                   "Intersections, 2011",
                   by_slabs<MinMax>),
            method("products", "float",
                   "b * inverse - o * inverse, as a fused operation "
                   "would have it",
                   by_slabs<Products>),
            method("ordered", "float", williams, by_slabs<Ordered>),
            method("ordered", "double", williams, by_slabs<OrderedInDoubles>),
            method("padded", "float", ize, by_slabs<Padded>),
            method("padded, four at once", "float", ize + "", in_fours),
            method("padded, two at once", "double", ize + "; accelerator/bvh/ray_box.h", in_pairs),
            method(run.name_of("box_entry", "divided"), "double",
                   "Kay and Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986", by_slot)};
}

std::vector<std::string> missed_header() {
    std::vector<std::string> header{"method"};
    for (const auto& workload : box_workloads(1, 1)) header.push_back(workload.name);
    return header;
}

std::vector<std::vector<std::string>> missed_rows(const ChapterRun& run) {
    const auto methods = box_methods(run);
    std::vector<std::vector<std::string>> rows;
    for (const auto& method : methods) rows.push_back({method.title()});
    for (const auto& workload : box_workloads(run.sized<std::size_t>(20'000, 500), run.seed)) {
        const Truth truth = box_truth(workload, run.threads);
        for (std::size_t i = 0; i < methods.size(); ++i)
            rows[i].push_back(number_text(wrong_decisions(answers_of(methods[i], workload), truth).misses));
    }
    return rows;
}

Experiment measure_ray_box(const ChapterRun& run) {
    Experiment experiment{.question = "ray_box",
                          .title = "Does a ray hit a box?",
                          .error_axis = "boxes missed that are hit [ppm]",
                          .rows = {}};
    const auto methods = box_methods(run);
    for (const auto& workload : box_workloads(run.sized<std::size_t>(100'000, 1'000), run.seed)) {
        const Truth truth = box_truth(workload, run.threads);
        for (const auto& one : methods)
            experiment.rows.push_back(measure(one, workload,
                                              [&](std::span<const std::optional<double>> answers) {
                                                  const WrongDecisions wrong = wrong_decisions(answers, truth);
                                                  // A box that is visited in vain costs a little time; only a box that
                                                  // is missed is wrong.
                                                  return Judgement{
                                                      .error = wrong.misses,
                                                      .error_bound = 3e6 / static_cast<double>(truth.size()),
                                                      .counts = {{"taken in vain ppm", wrong.false_hits}}};
                                              },
                                              {.repeats = run.sized(7, 3), .shortest = run.sized(0.002, 0.0002)}));
    }
    return experiment;
}

}  // namespace raylab::volumes

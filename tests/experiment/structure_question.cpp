#include "raylab/experiment/structure/structure_question.h"

#include "catch.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/image/color.h"
#include "raylab/image/color_map.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/report/structure/structure_trial.h"

using namespace raylab;

namespace {

std::shared_ptr<const Scene> ball() {
    return std::make_shared<const Scene>(mesh_scene(std::make_shared<const Mesh>(icosphere(2)), "ball"));
}

// A structure that loses every hit of every second triangle.
class Forgetful final : public Accelerator {
public:
    explicit Forgetful(const Scene& scene) : list_(make_accelerator("list", scene)) {}
    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        const auto hit = list_->closest(ray, traversal);
        return hit && hit->primitive.part % 2 == 0 ? hit : std::nullopt;
    }
    bool occluded(const Ray& ray, Traversal& traversal) const override { return closest(ray, traversal).has_value(); }
    std::size_t bytes() const override { return list_->bytes(); }

private:
    std::unique_ptr<Accelerator> list_;
};

const StructureMethod forgetful{"forgetful", "exact",
                                [](const Scene& scene) { return std::make_unique<Forgetful>(scene); }};

constexpr MeasureOptions quick{.repeats = 1, .shortest = 0};

}  // namespace

TEST_CASE("a mesh's camera sees all of it, and rays of all four kinds hit and miss") {
    const auto scene = ball();
    const auto workloads = ray_workloads("ball", scene, 900, 1);
    REQUIRE(workloads.size() == 4);
    CHECK(workloads[0].name == "ball: camera");
    for (const auto& workload : workloads) {
        INFO(workload.name);
        CHECK(workload.rays.size() == 900);
        if (workload.name == "ball: bounces") continue;  // no ray that leaves a ball hits it again
        const auto answers = true_answers(workload);
        const auto hits = std::ranges::count_if(answers, [](const auto& hit) { return hit.has_value(); });
        CHECK(hits < 890);
        if (workload.question == RayQuestion::nearest) CHECK(hits > 90);  // the light sees every surface that faces it
    }
}

TEST_CASE("rays at edges lie in box planes or go to vertices, and most hit") {
    const auto workload = edge_rays("ball", ball(), 400, 1);
    REQUIRE(workload.rays.size() == 400);
    const auto along_axis = [](const Ray& ray) {
        return std::abs(ray.direction.x) + std::abs(ray.direction.y) + std::abs(ray.direction.z) == 1;
    };
    CHECK(std::ranges::count_if(workload.rays, along_axis) > 100);
    const auto answers = true_answers(workload);
    CHECK(std::ranges::count_if(answers, [](const auto& hit) { return hit.has_value(); }) > 200);
}

TEST_CASE("workloads are values of their seed") {
    const auto scene = ball();
    const auto one = ray_workloads("ball", scene, 100, 7), again = ray_workloads("ball", scene, 100, 7);
    for (std::size_t i = 0; i < one.size(); ++i)
        for (std::size_t ray = 0; ray < one[i].rays.size(); ++ray) {
            CHECK(one[i].rays[ray].origin == again[i].rays[ray].origin);
            CHECK(one[i].rays[ray].direction == again[i].rays[ray].direction);
        }
}

TEST_CASE("the list is never wrong, and what it costs is counted a ray") {
    const auto workload = camera_rays("ball", ball(), 400);
    const auto row = measure_structure(structure_method("list"), workload, true_answers(workload), quick);
    CHECK(row.error == 0);
    CHECK(row.error_bound == 3e6 / 400);
    CHECK(row.counts.at("primitive tests") == 320);
    CHECK(row.counts.at("bytes a primitive") > 0);
}

TEST_CASE("a structure that loses hits is seen, whether it is asked for the nearest or for any") {
    for (auto workload : {camera_rays("ball", ball(), 400), incoherent_rays("ball", ball(), 400, 1)}) {
        for (const auto question : {RayQuestion::nearest, RayQuestion::any}) {
            workload.question = question;
            CHECK(measure_structure(forgetful, workload, true_answers(workload), quick).error > 50'000);
        }
    }
}

TEST_CASE("a hit with another t, or of another primitive, is a wrong answer") {
    const Hit hit{1, {0, 3}};
    CHECK(wrong_answers({hit}, {hit}, RayQuestion::nearest) == 0);
    CHECK(wrong_answers({Hit{std::nextafter(1.0, 2.0), {0, 3}}}, {hit}, RayQuestion::nearest) == 1);
    CHECK(wrong_answers({Hit{1, {0, 4}}}, {hit}, RayQuestion::nearest) == 1);
    CHECK(wrong_answers({Hit{1, {0, 4}}}, {hit}, RayQuestion::any) == 0);
}

TEST_CASE("a trial expects of a method to hold or to fail, and says what it saw") {
    const StructureTrial trial(camera_rays("ball", ball(), 400));
    const StructureMethod list = structure_method("list");
    CHECK(trial.never_wrong(list).as_expected);
    CHECK(trial.never_wrong(list).observed == "none wrong");
    CHECK_FALSE(trial.more_wrong_than(0, list).as_expected);
    CHECK(trial.more_wrong_than(0.05, forgetful).as_expected);
    CHECK_FALSE(trial.more_wrong_than(0.9, forgetful).as_expected);
    CHECK_FALSE(trial.never_wrong(forgetful).as_expected);
    CHECK(trial.shown(forgetful).as_expected);
    CHECK(trial.shown(forgetful).method == "forgetful, exact: ball: camera");
    CHECK_FALSE(trial.never_wrong(list).example);
    const auto example = trial.never_wrong(forgetful).example;
    REQUIRE(example);
    CHECK_THAT(example->drawing.notes.at(0), Catch::Contains("In truth: a hit at t = "));
    CHECK(example->drawing.notes.at(1) == "The answer: no hit.");
}

TEST_CASE("a cost map counts what the structure counts, and its picture says how much", "[threads]") {
    const auto scene = ball();
    const auto list = make_accelerator("list", *scene);
    const CameraFrame frame = camera_frame(scene->camera, {40, 30});
    const CostMap tests = cost_map(*list, frame, Cost::primitive_tests, 2);
    CHECK(tests.mean() == 320);
    CHECK(tests.largest() == 320);
    CHECK(cost_map(*list, frame, Cost::steps, 1).largest() == 0);

    CostMap ramp{10, 1};
    for (int x = 0; x < 10; ++x) ramp.costs.push_back(x);
    const Image picture = heat_map(ramp, "ramp", 9);
    const int square = picture.width() / ramp.width;  // a pixel of so narrow a map
    CHECK(square > 20);
    CHECK(picture.height() > square * ramp.height + 60);  // the legend
    for (int x = 1; x < 10; ++x) CHECK(luminance(picture.at(square * x, 0)) > luminance(picture.at(square * x - 1, 0)));
    // A quarter of the most is half as light as the eye sees it.
    const Image quarter = heat_map({1, 1, {2}}, "a quarter", 8);
    CHECK_THAT(luminance(quarter.at(0, 0)), WithinAbs(luminance(heat_color(0.5)), 0.005));
    CHECK(common_top({ramp}, 0.5) == 4);
}

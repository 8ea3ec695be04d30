#include "raylab/accelerator/shape_rows/boxed_list.h"
#include "accelerator/instruction_sets.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/experiment/adversarial/adversarial_rays.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

#include <atomic>
#include <bit>

// Tests of many shapes at once. The differential tester in tests/report checks that the answers are those of all
// structures.

using namespace raylab;
using namespace raylab::adversarial;

namespace {

Scene some_shapes(Draw& draw) {
    Scene scene = any_scene(draw, draw.integer(1, 12));
    for (int i = draw.integer(0, 40); i > 0; --i) {
        scene.objects.push_back(
            object(Sphere{draw.one_in(4) ? draw.on_lattice(-3, 3) : draw.in_cube(3), draw.uniform(0, 1)}));
    }
    return scene;
}

// Half of the rays leave a sphere, or end at one.
Ray any_ray(Draw& draw, const Scene& scene) {
    const SceneRays rays(scene);
    Ray ray =
        rays.draw(draw, static_cast<std::size_t>(draw.integer(0, static_cast<int>(SceneRays::kinds().size()) - 1)));
    const auto* sphere = std::get_if<Sphere>(&scene.objects.back().shape);
    if (sphere && draw.one_in(3)) {
        const Vec3f out = convert<float>(glm::normalize(convert<double>(draw.in_cube(1))));
        ray.origin = sphere->center + sphere->radius * out;
    }
    ray.range.min = draw.one_in(5) ? draw.uniform(0, 1) : 0;
    if (draw.one_in(3)) ray.range.max = ray.range.min + draw.uniform(0, 3);
    return ray;
}

std::string words(std::size_t place, const Ray& ray) {
    return fmt::format("place {}: {:a} {:a} {:a} + t {:a} {:a} {:a}, to {:a}", place, ray.origin.x, ray.origin.y,
                       ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.range.max);
}

std::optional<std::string> fault(const Primitives& primitives, const ShapeRows& rows, const RowQuestions& ask,
                                 const Ray& ray) {
    RowQuestions::Entries entries;
    const std::uint32_t open = ask.open(rows, ray, ray.range.max, entries);
    const auto [may_stop, sure] = ask.stops(rows, ray);
    for (std::size_t place = 0; place < rows.size(); ++place) {
        Traversal traversal;
        Nearest nearest(ray);
        primitives.test(rows.numbers[place], ray, nearest, traversal);
        const auto hit = nearest.hit();
        const auto says = [&](std::uint32_t places) { return (places >> place & 1) != 0; };
        if (hit && (!says(open) || !(entries[place] <= nearest.limit()))) return "lost " + words(place, ray);
        if (hit && sure == 0 && !says(may_stop)) return "no shadow " + words(place, ray);
        if (!hit && says(sure)) return "too sure " + words(place, ray);
    }
    return std::nullopt;
}

// Answers and counts, as bits.
std::vector<std::uint64_t> answered(const Scene& scene) {
    const BoxedList list(scene);
    Draw draw(3);
    Traversal traversal;
    traversal.toward(0);
    std::vector<std::uint64_t> answers;
    for (int i = 0; i < 5'000; ++i) {
        const Ray ray = any_ray(draw, scene);
        const auto hit = list.closest(ray, traversal);
        answers.push_back(hit ? std::bit_cast<std::uint64_t>(hit->t) : 0);
        answers.push_back(hit ? hit->primitive.object : ~std::uint64_t{0});
        answers.push_back(list.occluded(ray, traversal));
    }
    for (const std::uint64_t count : {traversal.box_tests, traversal.primitive_tests, traversal.exact_decisions})
        answers.push_back(count);
    return answers;
}

}  // namespace

TEST_CASE("of shapes asked about at once none that is hit is missed, none is entered too late, and what is sure is "
          "hit") {
    const RowQuestions ask = best_row_questions();
    std::atomic<int> sure = 0, closed = 0, asked = 0;  // counted by several threads
    const auto judge = [&](Draw& draw) -> std::optional<std::string> {
        const Scene scene = some_shapes(draw);
        const Primitives primitives(scene);
        const auto all = in_rows(primitives);
        for (int i = 0; i < 20; ++i) {
            const Ray ray = any_ray(draw, scene);
            for (const ShapeRows& rows : all) {
                if (auto found = fault(primitives, rows, ask, ray)) return found;
                const auto stops = ask.stops(rows, ray);
                sure += std::popcount(stops.sure);
                closed += static_cast<int>(rows.size()) - std::popcount(stops.open);
                asked += static_cast<int>(rows.size());
            }
        }
        return std::nullopt;
    };
    CHECK(faults(1'500, judge) == "");
    CHECK(closed > asked / 2);  // otherwise the boxes would be of no use
    CHECK(sure > asked / 200);
}

TEST_CASE("a list of boxes and spheres gives the same answers and counts with every instruction set") {
    Draw draw(11);
    const Scene scene = some_shapes(draw);
    const auto best = answered(scene);
    with_each_instruction_set([&] { CHECK(answered(scene) == best); });
}

TEST_CASE("a list of boxes and spheres is compiled as exactness needs for every instruction set") {
    with_each_instruction_set([] { CHECK(best_row_questions().faults() == CompiledFaults{}); });
}

TEST_CASE("a ray that begins inside of the sphere it leaves is stopped where the list says") {
    int stopped = 0, free = 0;
    for (std::uint64_t seed = 1; seed <= 4'000; ++seed) {
        Draw draw(seed);
        Scene scene;
        const Sphere sphere{draw.one_in(2) ? Vec3f(0) : draw.in_cube(100), draw.uniform(0.1, 3)};
        scene.objects.push_back(object(sphere));
        const BoxedList boxed(scene);
        const auto list = make_accelerator("list", scene);
        const auto unit = [&] { return convert<float>(glm::normalize(convert<double>(draw.in_cube(1)))); };
        const Vec3f out = unit();
        const float chord = draw.uniform(-1.2f, 1.2f);  // of the diameter; where it is negative the range is empty
        for (const Vec3f direction : {-out, out, unit()}) {
            const Ray ray{sphere.center + sphere.radius * out, direction, {0, 2 * sphere.radius * chord}, {0, 0}};
            Traversal one, other;
            const bool truth = list->occluded(ray, other);
            INFO("seed " << seed);
            REQUIRE(boxed.occluded(ray, one) == truth);
            ++(truth ? stopped : free);
        }
    }
    CHECK(stopped > 1'000);
    CHECK(free > 1'000);
}

TEST_CASE("rows hold every primitive once") {
    Draw draw(5);
    for (int i = 0; i < 200; ++i) {
        const Scene scene = some_shapes(draw);
        const Primitives primitives(scene);
        std::vector<int> seen(primitives.size());
        for (const ShapeRows& rows : in_rows(primitives)) {
            for (std::size_t place = 0; place < rows.size(); ++place) ++seen[rows.numbers[place]];
        }
        CHECK(std::ranges::all_of(seen, [](int times) { return times == 1; }));
    }
}

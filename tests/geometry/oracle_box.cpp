#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/geometry/box_entry.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

const Box unit{{0, 0, 0}, {1, 1, 1}};

double first_t(const Ray& ray, const Box& box = unit) {
    const auto answer = oracle::intersect(in<double>(ray), box);
    return answer.t ? answer.t->nearest() : -1;
}

}  // namespace

TEST_CASE("the oracle hits a closed box where the ray enters it, or at once from inside") {
    CHECK(first_t({{-2, 0.5f, 0.5f}, {1, 0, 0}}) == 2);
    CHECK(first_t({{-2, 1, 1}, {1, 0, 0}}) == 2);           // along an edge
    CHECK(first_t({{-1, -1, -1}, {1, 1, 1}}) == 1);         // through a corner
    CHECK(first_t({{0, 2, 0.5f}, {1, -1, 0}}) == 1);        // touches an edge
    CHECK(first_t({{0, 2.001f, 0.5f}, {1, -1, 0}}) == -1);  // hardly not
    CHECK(first_t({{0.5f, 0.5f, 0.5f}, {0, 0, 1}, {0.25f, 9}}) == 0.25);
    CHECK(first_t({{3, 0.5f, 0.5f}, {1, 0, 0}}) == -1);  // behind
    CHECK(first_t({{3, 0.5f, 0.5f}, {1, 0, 0}, {-9, 9}}) == -3);
    CHECK(first_t({{-2, 0.5f, 0.5f}, {1, 0, 0}, {0, 1.5f}}) == -1);
    CHECK(first_t({{-1, 0, 0.5f}, {1, 0, 0}}, {{0, 0, 0}, {1, 0, 1}}) == 1);  // in the plane of a flat box
}

TEST_CASE("where nothing is rounded the slab test says what the oracle says") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Vec3f a = draw.on_lattice(-3, 3), b = draw.on_lattice(-3, 3);
        const Box box{glm::min(a, b), glm::max(a, b)};
        Ray ray{draw.on_lattice(-6, 6), draw.lattice_direction(1)};
        if (draw.one_in(2)) ray.range = {-4, 4};
        const auto t = box_entry(in<double>(ray), convert<double>(box.min), convert<double>(box.max));
        return t.value_or(-100) == (oracle::intersect(in<double>(ray), box).hit() ? first_t(ray, box) : -100)
                   ? std::nullopt
                   : std::optional(adversarial::words(ray));
    };
    CHECK(faults(5'000, judge) == "");
}

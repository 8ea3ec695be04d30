#include "catch.h"

#include "raylab/experiment/transform/placed_sphere.h"
#include "raylab/experiment/transform/placed_sphere_methods.h"
#include "raylab/geometry/oracle/oracle.h"
#include "raylab/sampling/sequence.h"

#include <limits>

using namespace raylab;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// One ray through every method that computes in double or exactly.
std::vector<std::optional<double>> answers(const Affine& map, const Ray& ray) {
    std::vector<std::optional<double>> all;
    const std::vector<Affine> maps{map};
    const std::vector<PlacedSphereQuery> queries{{ray, 0}};
    for (const auto& method : placed_sphere_methods()) {
        if (method.number == "float") continue;
        std::optional<double> answer;
        method.answer(method.prepare ? method.prepare(maps) : std::any(), maps, queries, {&answer, 1});
        all.push_back(answer);
    }
    return all;
}

}  // namespace

TEST_CASE("a sphere scaled to an ellipsoid is hit where the ellipsoid is") {
    const Affine map = AffineSteps::scale({2, 1, 1}).then(AffineSteps::translate({10, 0, 0})).rounded();
    for (const auto& t : answers(map, {{0, 0, 0}, {1, 0, 0}})) CHECK(t == 8.0);
    for (const auto& t : answers(map, {{0, 1.5f, 0}, {1, 0, 0}})) CHECK(t == std::nullopt);
}

TEST_CASE("t counts directions of the world, whatever their length and the map's scale") {
    const Affine map = AffineSteps::scale({4, 4, 4}).then(AffineSteps::translate({0, 0, 20})).rounded();
    for (const auto& t : answers(map, {{0, 0, 0}, {0, 0, 2}})) CHECK(t == 8.0);
}

TEST_CASE("the direction made unit again gives t in object space's lengths") {
    const std::vector<Affine> maps{AffineSteps::scale({4, 4, 4}).then(AffineSteps::translate({0, 0, 20})).rounded()};
    const std::vector<PlacedSphereQuery> queries{{{{0, 0, 0}, {0, 0, 2}}, 0}};
    std::optional<double> answer;
    const auto method = unit_again_method();
    method.answer(method.prepare(maps), maps, queries, {&answer, 1});
    CHECK(answer == 4.0);
}

TEST_CASE("a mirrored sphere is hit, and the ray's range counts") {
    const Affine map = AffineSteps::scale({-1, 2, 1}).then(AffineSteps::translate({5, 0, 0})).rounded();
    for (const auto& t : answers(map, {{0, 0, 0}, {1, 0, 0}})) CHECK(t == 4.0);
    for (const auto& t : answers(map, {{0, 0, 0}, {1, 0, 0}, {4.5f, infinity}})) CHECK(t == 6.0);
    for (const auto& t : answers(map, {{0, 0, 0}, {1, 0, 0}, {0, 3.5f}})) CHECK(t == std::nullopt);
}

TEST_CASE("double methods agree with the oracle on rays that keep away from the rim") {
    for (std::uint64_t sample = 0; sample < 300; ++sample) {
        RandomSequence random(5, 0, sample);
        AffineSteps shear;
        shear.columns = {Vec3d{1, 0, 0}, Vec3d{random.between(-1, 1), 1, 0}, Vec3d{random.between(-1, 1), 0, 1}};
        const Affine map = shear.then(AffineSteps::rotate(random.unit_vector(), random.between(0, 360))).rounded();
        const Vec3d target = transform_point(map, random.unit_vector() * random.between(0, 0.9));
        const Vec3d origin = random.unit_vector() * 6.0;
        const Ray ray{convert<float>(origin), convert<float>(target - origin)};
        const auto truth = oracle::intersect(in<double>(ray), Shape{Sphere{{0, 0, 0}, 1}}, map);
        REQUIRE(truth.hit());
        for (const auto& t : answers(map, ray)) {
            REQUIRE(t);
            CHECK_THAT(*t, WithinRel(truth.t->nearest(), 1e-10));
        }
    }
}

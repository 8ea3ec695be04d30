#include "raylab/accelerator/trace_rays.h"

#include "catch.h"
#include "raylab/base/error.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/oracle/oracle.h"
#include "raylab/sampling/random.h"

#include <cmath>
#include <limits>

using namespace raylab;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Two squares one behind the other, seen from z = 5: triangles 0 and 1 at z = 1, 2 and 3 at z = 0.
std::shared_ptr<const Mesh> two_squares() {
    Mesh mesh;
    for (const float z : {1.0f, 0.0f})
        for (const Vec3f corner : {Vec3f{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}})
            mesh.vertices.push_back(corner);
    for (const std::uint32_t first : {0u, 4u})
        for (const Mesh::Face& face : {Mesh::Face{first, first + 1, first + 2}, {first, first + 2, first + 3}})
            mesh.faces.push_back(face);
    return std::make_shared<const Mesh>(mesh);
}

Ray down(float x, float y, Interval<float> range = {0, infinity}) { return {{x, y, 5}, {0, 0, -1}, range}; }

HitRecord trace(const Ray& ray, RayQuestion question = RayQuestion::nearest) {
    const auto result =
        trace_rays(two_squares(), std::vector{ray}, {.accelerator = "list", .question = question, .threads = 1});
    return result.hits.at(0);
}

constexpr HitRecord miss{-1, infinity};

// Rays from around a mesh to points near it, including its vertices.
std::vector<Ray> rays_at(const Mesh& mesh, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const auto coordinate = [&](std::uint64_t n) {
            return cast<float>(6 * random_number({.pixel = i, .dimension = n}) - 3);
        };
        const Vec3f origin{coordinate(0), coordinate(1), coordinate(2)};
        const Vec3f nearby = Vec3f{coordinate(3), coordinate(4), coordinate(5)} / 3.0f;
        const auto target = i % 2 == 0 ? mesh.vertices[i % mesh.vertices.size()] : nearby;
        rays.push_back({.origin = origin, .direction = target - origin});
    }
    return rays;
}

}  // namespace

TEST_CASE("a hit names its triangle in file order, and t") {
    CHECK(trace(down(0.5f, -0.5f)) == HitRecord{0, 4});
    CHECK(trace(down(-0.5f, 0.5f)) == HitRecord{1, 4});
    CHECK(trace(down(2, 0)) == miss);
}

TEST_CASE("among hits at equal t the lowest triangle wins") {
    CHECK(trace(down(0, 0)) == HitRecord{0, 4});  // on the diagonal, which both triangles share
    CHECK(trace(down(-1, 1)) == HitRecord{1, 4});
}

TEST_CASE("the range is closed, and may be empty") {
    CHECK(trace(down(0.5f, -0.5f, {4, 4})) == HitRecord{0, 4});
    CHECK(trace(down(0.5f, -0.5f, {std::nextafter(4.0f, 5.0f), infinity})) == HitRecord{2, 5});
    CHECK(trace(down(0.5f, -0.5f, {0, std::nextafter(4.0f, 0.0f)})) == miss);
    CHECK(trace(down(0.5f, -0.5f, {5, 4})) == miss);
    // Behind the origin, where the range includes it.
    CHECK(trace({{0.5f, -0.5f, -5}, {0, 0, -1}, {-10, 0}}) == HitRecord{0, -6});
}

TEST_CASE("t is the float nearest to the exact one, infinity where that is out of range") {
    CHECK(trace({{0.5f, -0.5f, 5}, {0, 0, -3}}).t == 4.0f / 3.0f);
    CHECK(trace({{0.5f, -0.5f, 5}, {0, 0, -1e-40f}}) == HitRecord{0, infinity});
}

TEST_CASE("asked for any hit, the answer is 0 or -1, and t is 0") {
    CHECK(trace(down(0.5f, -0.5f), RayQuestion::any) == HitRecord{0, 0});
    CHECK(trace(down(-0.5f, 0.5f, {4.5f, 6}), RayQuestion::any) == HitRecord{0, 0});  // triangle 3
    CHECK(trace(down(2, 0), RayQuestion::any) == HitRecord{-1, 0});
}

TEST_CASE("the hits are the same bits for any number of threads and every accelerator", "[threads]") {
    const auto mesh = std::make_shared<const Mesh>(trefoil_knot(0.5, 5));
    const auto rays = rays_at(*mesh, 5000);
    const auto expected = trace_rays(mesh, rays, {.accelerator = "list", .threads = 1});
    CHECK(std::ranges::count(expected.hits, miss) > 100);
    CHECK(std::ranges::count(expected.hits, miss) < 4900);
    for (const std::string& accelerator : accelerator_names())
        for (const int threads : {1, 2, 7}) {
            INFO(accelerator << ", " << threads << " threads");
            const auto result = trace_rays(mesh, rays, {.accelerator = accelerator, .threads = threads});
            CHECK(to_bytes(result.hits) == to_bytes(expected.hits));
            CHECK(result.threads == threads);
            CHECK(result.counts.primitive_tests > 0);
        }
}

TEST_CASE("the hits are the oracle's") {
    const auto mesh = std::make_shared<const Mesh>(icosphere(1));
    const auto rays = rays_at(*mesh, 300);
    const auto hits = trace_rays(mesh, rays).hits;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        INFO("ray " << i);
        const auto truth = oracle::intersect(in<double>(rays[i]), Shape(mesh));
        REQUIRE(truth.hit() == (hits[i].triangle >= 0));
        if (truth.hit()) CHECK(truth.t->error_in_ulp(hits[i].t) <= 1);
    }
}

TEST_CASE("a bulk of rays costs what its counts say, whatever the number of threads", "[threads]") {
    const auto mesh = std::make_shared<const Mesh>(icosphere(2));
    const auto rays = rays_at(*mesh, 3000);
    const auto one = trace_rays(mesh, rays, {.accelerator = "list", .threads = 1});
    const auto two = trace_rays(mesh, rays, {.accelerator = "list", .threads = 2});
    CHECK(one.counts.primitive_tests == 3000 * mesh->faces.size());
    CHECK(two.counts.primitive_tests == one.counts.primitive_tests);
    CHECK(two.counts.exact_decisions == one.counts.exact_decisions);
}

TEST_CASE("no rays, no hits") { CHECK(trace_rays(two_squares(), {}, {.accelerator = "list"}).hits.empty()); }

TEST_CASE("an accelerator nobody knows is refused") {
    CHECK_THROWS_AS(trace_rays(two_squares(), {}, {.accelerator = "wishful"}), Error);
}

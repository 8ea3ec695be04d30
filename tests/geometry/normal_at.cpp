#include "catch.h"
#include "geometry/every_shape.h"
#include "geometry/verdict.h"
#include "raylab/geometry/surface/surface_position.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

Vec3d normal_at(const Ray& ray, const Candidate& candidate, const Shape& shape, const Affine& placement) {
    const auto& [t, t_error, u, v, part] = candidate;
    return surface_position(ray, {.t = t, .primitive = {}, .u = u, .v = v, .part = part}, shape, placement).normal;
}

Vec3d normal_of(const Ray& ray, const Shape& shape, const Affine& placement = {}) {
    DecisionCounts decisions;
    const auto hit = intersect(ray, shape, placement, decisions);
    REQUIRE(hit);
    return normal_at(ray, *hit, shape, placement);
}

bool equal(const Vec3d& a, const Vec3d& b) { return glm::length(a - b) < 1e-12; }

constexpr Ray down{{0.25f, 0.25f, 9}, {0, 0, -1}};

}  // namespace

TEST_CASE("a shape's normal points outward, a flat one's by the right-hand rule or as given") {
    CHECK(equal(normal_of({{0, 0, 9}, {0, 0, -1}}, Sphere{{0, 0, 0}, 2}), {0, 0, 1}));
    CHECK(equal(normal_of({{0, 0, 0}, {0, 0, -1}}, Sphere{{0, 0, 0}, 2}), {0, 0, -1}));
    CHECK(equal(normal_of(down, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {0, 0, 1}));
    CHECK(equal(normal_of(down, Triangle{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}), {0, 0, -1}));
    CHECK(equal(normal_of(down, Polygon{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}), {0, 0, 1}));
    CHECK(equal(normal_of(down, Disk{{0, 0, 0}, {0, 0, -3}, 1}), {0, 0, -1}));
    CHECK(equal(normal_of(down, Annulus{{0, 0, 0}, {0, 0, -3}, 0.25f, 1}), {0, 0, -1}));
    CHECK(equal(normal_of(down, Plane{{0, 0, 0}, {0, 0, 5}}), {0, 0, 1}));
    CHECK(equal(normal_of(down, Cylinder{{0, 0, 0}, {0, 0, 1}, 1, Ends::capped}), {0, 0, 1}));
    CHECK(
        equal(normal_of({{0.25f, 0.25f, -9}, {0, 0, 1}}, Cylinder{{0, 0, 0}, {0, 0, 1}, 1, Ends::capped}), {0, 0, -1}));
    CHECK(equal(normal_of({{9, 0, 0.5f}, {-1, 0, 0}}, Cylinder{{0, 0, 0}, {0, 0, 1}, 1}), {1, 0, 0}));
    // A cone of half a right angle, apex up.
    CHECK(equal(normal_of({{9, 0, 0.5f}, {-1, 0, 0}}, Cone{{0, 0, 0}, {0, 0, 1}, 1, 0}),
                Vec3d(1, 0, 1) / std::sqrt(2.0)));
    CHECK(equal(normal_of({{0, 0, 9}, {0, 0, -1}}, Cone{{0, 0, 0}, {0, 0, 1}, 1, 0}), {0, 0, 1}));
}

TEST_CASE("a placed normal is carried by the inverse transpose, under mirrors too") {
    Affine stretched;
    stretched.columns[0] = {2, 0, 0};  // (x / 2)^2 + y^2 = 1 has the gradient (x / 2, 2 y)
    CHECK(equal(normal_of({{1, 9, 0}, {0, -1, 0}}, Sphere{{0, 0, 0}, 1}, stretched),
                glm::normalize(Vec3d(0.5, 2 * std::sqrt(0.75), 0))));
    Affine mirror;
    mirror.columns[2] = {0, 0, -1};
    CHECK(equal(normal_of({{0, 0, 9}, {0, 0, -1}}, Sphere{{0, 0, 0}, 2}, mirror), {0, 0, 1}));
    CHECK(equal(normal_of(down, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, mirror), {0, 0, -1}));
}

TEST_CASE("a normal agrees with the side that one-sided shapes are seen from") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Object target = object(shape_of_every_kind(draw), any_placement(draw));
        const Vec3d aim = transform_point(target.placement, convert<double>(any_point(draw)));
        const Ray ray = through(any_point(draw), aim);
        DecisionCounts decisions;
        const auto seen = [&](Sides sides) { return intersect(ray, target.shape, target.placement, decisions, sides); };
        const auto front = seen(Sides::front), back = seen(Sides::back);
        if (front && back && front->t == back->t) return std::nullopt;  // a tangent ray or one through an apex
        for (const auto& [hit, outward] : {std::pair{front, -1}, {back, 1}}) {
            if (!hit) continue;
            const Vec3d normal = normal_at(ray, *hit, target.shape, target.placement);
            const double along = dot(glm::normalize(convert<double>(ray.direction)), normal);
            if (std::abs(glm::length(normal) - 1) < 1e-12 && outward * along > -1e-5) continue;
            return fmt::format("shape {}, {}: {}", target.shape.index(), along, adversarial::words(ray));
        }
        return std::nullopt;
    };
    CHECK(faults(100'000, judge) == "");
}

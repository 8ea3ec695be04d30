#include "catch.h"

#include "raylab/sampling/random.h"
#include "raylab/tracer/lone_sphere.h"

#include <cmath>

using namespace raylab;

namespace {

class Draw {
public:
    explicit Draw(std::uint64_t seed) : seed_(seed) {}

    double below(double limit) { return limit * random_number({.seed = seed_, .dimension = drawn_++}); }
    double power_of_two(double least, double most) { return std::exp2(least + below(most - least)); }
    Vec3d direction() { return glm::normalize(Vec3d(below(2) - 1, below(2) - 1, below(2) - 1)); }

private:
    std::uint64_t seed_, drawn_ = 0;
};

Scene one_sphere(const Vec3d& center, double radius) {
    Scene scene;
    scene.materials = {{}};
    scene.objects = {{.shape = Sphere{convert<float>(center), cast<float>(radius)}}};
    return scene;
}

// Past the sphere's rim, by less the higher k is, from outside or from within.
Ray grazing(Draw& draw, const Vec3d& center, double radius) {
    const double k = draw.below(50);
    const Vec3d outward = draw.direction(), along = glm::normalize(cross(outward, draw.direction()));
    const Vec3d nearest = center + outward * radius * (1 - std::exp2(-k));
    const bool within = draw.below(2) < 1;
    const double back = radius * (within ? draw.below(1) * std::exp2(-k / 2) : draw.power_of_two(-4, 20));
    return {convert<float>(nearest - along * back), convert<float>(along)};
}

}  // namespace

TEST_CASE("the side that a ray comes to is the same by the sphere's root and by its normal") {
    std::uint64_t outside = 0, inside = 0;
    for (std::uint64_t seed = 0; seed < 40'000; ++seed) {
        Draw draw(seed);
        const double radius = draw.power_of_two(-10, 10);
        const Vec3d center = convert<double>(convert<float>(draw.direction() * radius * draw.power_of_two(-5, 21)));
        const Scene scene = one_sphere(center, radius);
        REQUIRE(LoneSphere::suits(scene));
        const auto list = make_accelerator("list", scene);
        const LoneSphere lone(scene, *list, Lighting(scene));
        const Ray ray = grazing(draw, center, radius);
        TestCounts counts;
        const auto hit = lone.closest(ray, counts);
        if (!hit) continue;
        const auto at = lone.sphere(*hit).point(hit->near);
        const Vec3d direction = convert<double>(ray.direction);
        const bool by_normal = !(dot(at.normal, glm::normalize(direction)) > 0);
        INFO("seed " << seed);
        CHECK(LoneSphere::is_outside(*hit, at, direction) == by_normal);
        ++(by_normal ? outside : inside);
    }
    CHECK(outside > 4'000);
    CHECK(inside > 4'000);
}

TEST_CASE("a lone sphere is one that is seen from both sides and is no speck beside its coordinates") {
    Scene scene = one_sphere({100, 0, 0}, 1);
    CHECK(LoneSphere::suits(scene));
    CHECK_FALSE(LoneSphere::suits(one_sphere({100, 0, 0}, 1e-6)));
    scene.objects[0].sides = Sides::front;
    CHECK_FALSE(LoneSphere::suits(scene));
    scene.objects[0].sides = Sides::both;
    scene.objects.push_back(scene.objects[0]);
    CHECK_FALSE(LoneSphere::suits(scene));
}

#include "raylab/accelerator/light_buffer/light_buffer.h"

#include "accelerator/shadow_rays.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/primitives.h"

#include <fmt/format.h>

#include <algorithm>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

struct Trial {
    Scene scene;
    double size;
    Vec3d light;
    std::shared_ptr<const Primitives> primitives;
    LightBuffer buffer;
    std::unique_ptr<Accelerator> list;

    Trial(Draw& draw, Scene made, double extent, LightBufferOptions options)
        : scene(std::move(made)),
          size(extent),
          light(any_light(draw, scene, size)),
          primitives(std::make_shared<Primitives>(scene)),
          buffer(primitives, light, options),
          list(make_accelerator("list", scene)) {}

    Ray any_shadow_ray(Draw& draw) const {
        const double far = draw.one_in(8) ? draw.number(0, 60) : draw.number(0, 3);
        const auto corner = draw.one_in(3) ? some_corner(draw, scene) : std::nullopt;
        const Vec3d way = corner ? *corner - light : any_way(draw, buffer.resolution()) * size;
        Ray ray = shadow_ray_to(light, light + way * far);
        if (draw.one_in(3) && !scene.objects.empty()) {  // from a surface, or from something that is nearly one
            Traversal traversal;
            const auto hit =
                list->closest({ray.origin, convert<float>(convert<double>(draw.in_cube(1)) * size)}, traversal);
            if (hit) ray.leaving = hit->primitive;
        }
        if (draw.one_in(20)) ray.range.min = cast<float>(draw.number(0, 1)) * ray.range.max;
        if (draw.one_in(20)) ray.range.max *= cast<float>(draw.number(0, 1));
        return ray;
    }
};

Trial any_trial(Draw& draw, Listing listing = Listing::conservative) {
    const LightBufferOptions options{.resolution = 1 << draw.integer(0, 5), .listing = listing};
    switch (draw.integer(0, 6)) {
        case 0:
            return {draw, scene_of(soup(draw, 100, 2)), 2, options};
        case 1:
            return {draw, scene_of(floor_of(5)), 5, options};
        case 2:
            return {draw, scene_of(soup(draw, 60, 1e-20f)), 1e-20, options};
        case 4:
            return {draw, room(draw), 3, options};
        case 3:
            return {draw, scene_of(soup(draw, 60, 1e20f)), 1e20, options};
        default:
            return {draw, any_scene(draw, draw.integer(0, 20)), 3, options};
    }
}

struct Tally {
    int known = 0, unknown = 0, stopped = 0, without_test = 0;
};

std::string words(const Trial& trial, const Ray& ray) {
    return fmt::format("light ({:a}, {:a}, {:a}), {}", trial.light.x, trial.light.y, trial.light.z,
                       adversarial::words(ray));
}

std::string compare(Draw& draw, const Trial& trial, int rays, Tally& tally) {
    for (int i = 0; i < rays; ++i) {
        const Ray ray = trial.any_shadow_ray(draw);
        Traversal one, other;
        const auto known = trial.buffer.occluded(ray, one);
        ++(known ? tally.known : tally.unknown);
        if (!known) continue;
        const bool truth = trial.list->occluded(ray, other);
        if (truth) ++tally.stopped;
        if (truth && one.primitive_tests == 0) ++tally.without_test;
        if (*known != truth) return fmt::format("{} instead of {}: {}", *known, truth, words(trial, ray));
    }
    return "";
}

}  // namespace

TEST_CASE("a conservative light buffer knows what the list knows, of every ray to its light") {
    Tally tally;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        Draw draw(seed);
        const Trial trial = any_trial(draw);
        INFO("seed " << seed);
        CHECK(compare(draw, trial, 500, tally) == "");
    }
    INFO(tally.known << " known, " << tally.unknown << " unknown, " << tally.stopped << " stopped, "
                     << tally.without_test << " of them without a test");
    CHECK(tally.unknown < tally.known / 10);
    CHECK(tally.stopped > tally.known / 10);
    CHECK(tally.without_test > tally.stopped / 20);
}

TEST_CASE("rectangles miss nothing either, and list more") {
    Tally tally;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Draw draw(seed);
        CHECK(compare(draw, any_trial(draw, Listing::rectangles), 300, tally) == "");
    }
    Draw draw(1);
    const Scene scene = scene_of(soup(draw, 100, 2));
    const auto primitives = std::make_shared<const Primitives>(scene);
    const LightBuffer tight(primitives, {5, 1, 2}, {32}), loose(primitives, {5, 1, 2}, {32, Listing::rectangles});
    CHECK(tight.bytes() < loose.bytes());
}

TEST_CASE("triangles without area, or with an area that roundings lose, cover no cell in any listing") {
    Tally tally;
    for (const Listing listing : {Listing::conservative, Listing::rectangles}) {
        for (std::uint64_t seed = 1; seed <= 400; ++seed) {
            Draw draw(seed);
            const auto whole = [&](int most) {
                return Vec3f(draw.integer(-most, most), draw.integer(-most, most), draw.integer(-most, most));
            };
            const Vec3f middle = whole(3), aside = whole(1);
            Triangle flat{middle, middle + aside, middle - aside};
            if (draw.one_in(2)) flat.c.x = std::nextafter(flat.c.x, 9.0f);
            const Trial trial(draw, scene_of({flat}), 5, {.resolution = draw.one_in(2) ? 16 : 64, .listing = listing});
            INFO("seed " << seed);
            CHECK(compare(draw, trial, 50, tally) == "");
        }
    }
    CHECK(tally.known > 10'000);
}

TEST_CASE("a light buffer made of cells' centres misses what is smaller than a cell") {
    Draw draw(1);
    const Scene scene = scene_of(soup(draw, 100, 2));
    const auto primitives = std::make_shared<const Primitives>(scene);
    const Vec3d light{3, 1, 2};
    const LightBuffer right(primitives, light, {16}), wrong(primitives, light, {16, Listing::centers});
    int stopped = 0, missed = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = shadow_ray_to(light, light + convert<double>(draw.in_cube(8)));
        Traversal traversal;
        if (!right.occluded(ray, traversal).value_or(false)) continue;
        ++stopped;
        if (!*wrong.occluded(ray, traversal)) ++missed;
    }
    CHECK(missed > stopped / 10);
}

TEST_CASE("a light buffer knows nothing of rays that do not go to its light") {
    const Scene scene{.objects = {object(Sphere{{3, 0, 0}, 1})}};
    const LightBuffer buffer(std::make_shared<const Primitives>(scene), {0, 5, 0});
    const auto knows = [&](const Ray& ray) {
        Traversal traversal;
        return buffer.occluded(ray, traversal).has_value();
    };
    CHECK(knows({{0, -3, 0}, {0, 1, 0}, {0, 7.99f}}));
    CHECK_FALSE(knows({{0, -3, 0}, {0, 1, 0}}));              // it has no end
    CHECK_FALSE(knows({{0, -3, 0}, {0, 1, 0}, {0, 8.01f}}));  // it goes beyond the light
    CHECK_FALSE(knows({{0, -3, 0}, {0, 1, 0}, {-1, 7}}));     // it begins behind the point
    CHECK_FALSE(knows({{0, -3, 0}, {0, -1, 0}, {0, 7}}));     // it goes away from the light
    CHECK_FALSE(knows({{0, -3, 0}, {0.01f, 1, 0}, {0, 7}}));  // it passes beside the light
    CHECK_FALSE(knows({{0, -3, 0}, {0, 0, 0}, {0, 7}}));      // it has no direction
    CHECK_FALSE(knows({{0, 5, 0}, {0, 1, 0}, {0, 1}}));       // it starts at the light
    // It starts far outside the scene, where floats are sparse.
    CHECK_FALSE(knows({{0, -1e6f, 0}, {0, 1, 0}, {0, 1e6f}}));
    CHECK_FALSE(knows({{0, -3, 0}, {0, std::nanf(""), 0}, {0, 7}}));
}

TEST_CASE(
    "behind what fills a cell there is shadow without a test, but not for rays that leave it or end before the light") {
    const Scene scene{.objects = {object(Polygon{{{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}}}),
                                  object(Sphere{{0, -2, 0}, 0.1f})}};
    const LightBuffer buffer(std::make_shared<const Primitives>(scene), {0, 5, 0});
    const auto ask = [&](const Ray& ray) {
        Traversal traversal;
        const auto found = buffer.occluded(ray, traversal);
        return std::pair(found, traversal.primitive_tests);
    };
    const float end = 8 * (1 - 0x1p-21f);
    CHECK(ask({{0, -3, 0}, {0, 1, 0}, {0, end}}) == std::pair(std::optional(true), std::uint64_t{0}));
    CHECK_FALSE(ask({{0, -3, 0}, {0, 1, 0}, {0, end}, {0, 0}}).first);
    CHECK_FALSE(ask({{0, -3, 0}, {0, 1, 0}, {0, 2}}).first);
    CHECK_FALSE(ask({{0, -3, 0}, {0, 1, 0}, {1, end}}).first);
    CHECK(buffer.list({3, 32, 32}).size() == 1);  // primitives behind it are not listed
}

#include "raylab/accelerator/light_buffer.h"

#include "accelerator/scenes.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/light_buffered.h"
#include "raylab/accelerator/list.h"
#include "raylab/accelerator/primitives.h"

#include <fmt/format.h>

#include <algorithm>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// A direction from the light that is hard: in the border of two cells, along the cube's edges and through its corners.
Vec3d any_way(Draw& draw, int resolution) {
    Vec3d way = convert<double>(draw.in_cube(1));
    const auto border = [&] { return 2.0 * draw.integer(0, resolution) / resolution - 1; };
    const int axis = draw.integer(0, 2);
    if (draw.one_in(2)) way[axis] = draw.one_in(2) ? 1 : -1;
    if (draw.one_in(2)) way[(axis + 1) % 3] = border();
    if (draw.one_in(3)) way[(axis + 2) % 3] = border();
    if (draw.one_in(10)) way = convert<double>(draw.lattice_direction(1));
    return way;
}

// A corner of a shape, or a point of an edge: the borders of shadows.
std::optional<Vec3d> some_corner(Draw& draw, const Scene& scene) {
    if (scene.objects.empty()) return std::nullopt;
    const Object& object =
        scene.objects[static_cast<std::size_t>(draw.integer(0, static_cast<int>(scene.objects.size()) - 1))];
    const auto between = [&](const Vec3f& a, const Vec3f& b) {
        const Vec3d p = convert<double>(a), q = convert<double>(b);
        return transform_point(object.placement, draw.one_in(2) ? p : p + (q - p) * draw.number(0, 1));
    };
    if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&object.shape)) {
        const Triangle t =
            (*mesh)->triangle(static_cast<std::size_t>(draw.integer(0, static_cast<int>((*mesh)->faces.size()) - 1)));
        return between(t.a, t.b);
    }
    if (const auto* t = std::get_if<Triangle>(&object.shape)) return between(t->b, t->c);
    if (const auto* polygon = std::get_if<Polygon>(&object.shape))
        return between(polygon->vertices[0], polygon->vertices[1]);
    const auto box = bounds(object.shape, object.placement);
    return box ? std::optional(convert<double>(box->min)) : std::nullopt;
}

// On the scene's lattice, in its objects, and as near to a corner of one as rays stray, or nearer.
Vec3d any_light(Draw& draw, const Scene& scene, double size) {
    if (draw.one_in(3)) return convert<double>(draw.on_lattice(-4, 4)) * (size / 3);
    if (draw.one_in(3) && !scene.objects.empty())
        return transform_point(scene.objects[0].placement, convert<double>(any_point(draw)) * (size / 3));
    const auto corner = draw.one_in(3) ? some_corner(draw, scene) : std::nullopt;
    if (corner) return *corner + convert<double>(draw.in_cube(1)) * (size * std::pow(10.0, draw.integer(-8, -1)));
    return convert<double>(draw.in_cube(2)) * size;
}

// As the tracer casts them: from floats, in a direction of floats, not quite as far as the light.
Ray feeler_to(const Vec3d& light, const Vec3d& point) {
    const Vec3f origin = convert<float>(point);
    const Vec3d way = light - convert<double>(origin);
    const double distance = glm::length(way);
    return {origin, convert<float>(way / distance), {0, cast<float>(distance * (1 - 0x1p-21))}};
}

// Large walls, which cover many cells, among small things: balls, triangles and quadrilaterals.
Scene room(Draw& draw) {
    Scene scene;
    const auto add = [&](Shape shape) {
        scene.objects.push_back(object(std::move(shape)));
        if (draw.one_in(4)) scene.objects.back().sides = any_sides(draw);
    };
    for (int i = 0; i < 4; ++i) {
        const Vec3f at = draw.in_cube(4), u = draw.lattice_direction(4), v = draw.in_cube(4);
        add(Polygon{{at, at + u, at + u + v, at + v}});
        add(Polygon{
            {at, at + u, at + u + v + draw.in_cube(0.7), at + v}});  // not flat: its surface is beside its corners
        add(Polygon{{at, at + u, at + v, at, at + u, at + v}});  // round twice, so nothing is inside
        add(Triangle{at + u, draw.in_cube(5), draw.in_cube(5)});
        add(Sphere{draw.in_cube(4), any_radius(draw)});
        add(Sphere{draw.in_cube(4), draw.uniform(0.01, 0.1)});
    }
    return scene;
}

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

    Ray any_feeler(Draw& draw) const {
        const double far = draw.one_in(8) ? draw.number(0, 60) : draw.number(0, 3);
        const auto corner = draw.one_in(3) ? some_corner(draw, scene) : std::nullopt;
        const Vec3d way = corner ? *corner - light : any_way(draw, buffer.resolution()) * size;
        Ray ray = feeler_to(light, light + way * far);
        if (draw.one_in(3) && !scene.objects.empty()) {  // from a surface, or what is nearly one
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
        case 0: return {draw, scene_of(soup(draw, 100, 2)), 2, options};
        case 1: return {draw, scene_of(floor_of(5)), 5, options};
        case 2: return {draw, scene_of(soup(draw, 60, 1e-20f)), 1e-20, options};
        case 4: return {draw, room(draw), 3, options};
        case 3: return {draw, scene_of(soup(draw, 60, 1e20f)), 1e20, options};
        default: return {draw, any_scene(draw, draw.integer(0, 20)), 3, options};
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
        const Ray ray = trial.any_feeler(draw);
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

TEST_CASE("a light buffer made of cells' centres misses what is smaller than a cell") {
    Draw draw(1);
    const Scene scene = scene_of(soup(draw, 100, 2));
    const auto primitives = std::make_shared<const Primitives>(scene);
    const Vec3d light{3, 1, 2};
    const LightBuffer right(primitives, light, {16}), wrong(primitives, light, {16, Listing::centers});
    int stopped = 0, missed = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = feeler_to(light, light + convert<double>(draw.in_cube(8)));
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
    CHECK_FALSE(knows({{0, -3, 0}, {0, 1, 0}}));                                // on and on
    CHECK_FALSE(knows({{0, -3, 0}, {0, 1, 0}, {0, 8.01f}}));                    // past the light
    CHECK_FALSE(knows({{0, -3, 0}, {0, 1, 0}, {-1, 7}}));                       // begins behind the point
    CHECK_FALSE(knows({{0, -3, 0}, {0, -1, 0}, {0, 7}}));                       // away from it
    CHECK_FALSE(knows({{0, -3, 0}, {0.01f, 1, 0}, {0, 7}}));                    // beside it
    CHECK_FALSE(knows({{0, -3, 0}, {0, 0, 0}, {0, 7}}));                        // nowhere
    CHECK_FALSE(knows({{0, 5, 0}, {0, 1, 0}, {0, 1}}));                         // from it
    CHECK_FALSE(knows({{0, -1e6f, 0}, {0, 1, 0}, {0, 1e6f}}));  // from far beyond the scene: floats are rare there
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
    CHECK(buffer.list({3, 32, 32}).size() == 1);  // what lies behind is not listed
}

TEST_CASE("a structure with light buffers answers as the list does, whatever it is asked after what") {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Draw draw(seed);
        Scene scene = any_scene(draw, draw.integer(0, 12));
        for (int i = 0; i < 3; ++i) scene.lights.push_back({.kind = PointLight{any_light(draw, scene, 3)}});
        scene.lights.push_back({.kind = DistantLight{{0, -1, 0}}});
        scene.lights.push_back({.kind = SpotLight{any_light(draw, scene, 3), {0, 0, 0}}});
        const auto list = make_accelerator("list", scene);
        const LightBuffered buffered(make_accelerator("aabb_tree", scene), scene, {.resolution = 8});
        Traversal remembering, nothing;
        for (int i = 0; i < 300; ++i) {
            const auto light = static_cast<std::size_t>(draw.integer(0, 4));
            const auto* point = std::get_if<PointLight>(&scene.lights[light].kind);
            const Vec3d from = convert<double>(draw.in_cube(draw.one_in(9) ? 500 : 5));
            const Ray ray = point && !draw.one_in(5) ? feeler_to(point->position, from)
                                                     : Ray{convert<float>(from), draw.lattice_direction(1), {0, 4}};
            remembering.toward(light);
            Traversal alone;
            const bool truth = list->occluded(ray, alone);
            INFO("seed " << seed << ", light " << light << ": " << adversarial::words(ray));
            CHECK(buffered.occluded(ray, remembering) == truth);
            CHECK(buffered.occluded(ray, nothing) == truth);
            CHECK(buffered.closest(ray, remembering).has_value() == truth);
        }
    }
}

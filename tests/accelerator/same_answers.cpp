#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/adversarial/adversarial_rays.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>

// Tests of the guarantees of the list and of the common interface. The differential tester in tests/report checks that
// every structure answers as the list does.

using namespace raylab;
using namespace raylab::adversarial;

namespace {

Ray any_ray(Draw& draw, const Scene& scene) {
    const int kinds = static_cast<int>(SceneRays::kinds().size());
    return SceneRays(scene).draw(draw, static_cast<std::size_t>(draw.integer(0, kinds - 1)));
}

std::string words(const std::optional<Hit>& hit) {
    return hit ? fmt::format("{}/{} at {:a}", hit->primitive.object, hit->primitive.part, hit->t) : "nothing";
}

oracle::Answer intersect_object(const Ray& ray, const Object& object) {
    return oracle::intersect(in<double>(ray), object.shape, object.placement, object.sides);
}

// The first of the objects along the ray, at equal t the one with the lowest number.
std::optional<std::uint32_t> first_object(const Ray& ray, const Scene& scene) {
    std::optional<std::uint32_t> first;
    std::optional<oracle::ExactT> smallest;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const auto answer = intersect_object(ray, scene.objects[i]);
        if (!answer.hit() || (smallest && is_gteq(answer.t->compare(*smallest)))) continue;
        first = i;
        smallest = answer.t;
    }
    return first;
}

}  // namespace

TEST_CASE("the first hit is the oracle's, and of equal ones the lowest") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        Scene scene = any_scene(draw, 4);
        if (draw.one_in(4)) scene.objects.push_back(object(any_annulus(draw), any_placement(draw)));
        if (draw.one_in(2)) scene.objects.push_back(scene.objects[0]);  // a tie with the first
        const auto list = make_accelerator("list", scene);
        const Ray ray = any_ray(draw, scene);
        Traversal traversal;
        const auto given = list->closest(ray, traversal);
        const auto first = first_object(ray, scene);
        if (given.has_value() != first.has_value() || (given && given->primitive.object != *first)) {
            return fmt::format("{} instead of object {}: {}", words(given), first ? static_cast<int>(*first) : -1,
                               adversarial::words(ray));
        }
        return std::nullopt;
    };
    CHECK(faults(4'000, judge) == "");
}

TEST_CASE("hits at the same exact t are equal, however their t were rounded, and the lowest wins") {
    // Triangles in different planes about one point, in multiples of 2^-20: products need more bits than a double has.
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const auto short_number = [&] { return std::ldexp(cast<float>(draw.integer(-(1 << 20), 1 << 20)), -20); };
        const auto corner = [&] { return Vec3f(short_number(), short_number(), short_number()); };
        const Vec3f point = corner(), origin = corner();
        if (point == origin) return std::nullopt;
        std::vector<Triangle> triangles;
        for (int i = 0; i < 3; ++i) {
            const Vec3f a = corner(), b = corner();
            triangles.push_back({a, b, point * 3.0f - a - b});  // exact: 24 bits suffice
        }
        const Scene scene = scene_of(triangles);
        const auto list = make_accelerator("list", scene), tree = make_accelerator("bvh", scene);
        const Ray ray{origin, point - origin, {0.5f, 2}};
        Traversal traversal;
        const auto hit = list->closest(ray, traversal), again = tree->closest(ray, traversal);
        const bool right = hit && hit->primitive == Primitive{0, 0} && same(hit, again);
        return right ? std::nullopt
                     : std::optional(fmt::format("{} and {}: {}", words(hit), words(again), adversarial::words(ray)));
    };
    CHECK(faults(2'000, judge) == "");
}

TEST_CASE("a flat primitive that a ray leaves is not hit again, a curved one may be") {
    const Scene scene{.objects = {object(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), object(Sphere{{0, 0, 5}, 1})}};
    for (const std::string& name : accelerator_names()) {
        const auto accelerator = make_accelerator(name, scene);
        Traversal traversal;
        Ray ray{{0.25f, 0.25f, 0}, {0, 0, 1}};
        CHECK(accelerator->closest(ray, traversal)->primitive == Primitive{0, 0});
        ray.leaving = {0, 0};
        CHECK(accelerator->closest(ray, traversal)->primitive == Primitive{1, 0});
        ray.range.min = -1;  // some structures traverse differently where a range begins behind the origin
        CHECK(accelerator->closest(ray, traversal)->primitive == Primitive{1, 0});
        CHECK_FALSE(accelerator->occluded({ray.origin, ray.direction, {-1, 1}, {0, 0}}, traversal));
        ray = {{0, 0, 4}, {0, 0, 1}, {0.5f, 10}, {1, 0}};
        CHECK(accelerator->closest(ray, traversal)->t == 2);
    }
}

TEST_CASE("one-sided shapes are seen only from where their normal points") {
    const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};  // its normal is +z
    Affine mirror;
    mirror.columns[2] = {0, 0, -1};
    for (const auto& [placement, from] : {std::pair{Affine{}, 1.0f}, {mirror, -1.0f}}) {
        Scene scene{.objects = {object(triangle, placement)}};
        const Ray against{{0.25f, 0.25f, from}, {0, 0, -from}}, along{{0.25f, 0.25f, -from}, {0, 0, from}};
        Traversal traversal;
        scene.objects[0].sides = Sides::front;
        CHECK(make_accelerator("list", scene)->occluded(against, traversal));
        CHECK_FALSE(make_accelerator("list", scene)->occluded(along, traversal));
        scene.objects[0].sides = Sides::back;
        CHECK_FALSE(make_accelerator("list", scene)->occluded(against, traversal));
        CHECK(make_accelerator("list", scene)->occluded(along, traversal));
    }
}

TEST_CASE("a ray that stands still along axes hits however far, small or slow: every structure says so") {
    struct Still {
        std::string name;
        Scene scene;
        Ray ray;
        double t;
    };
    const Triangle across{{0, 0, 1}, {-1, 1, 1}, {0, 1, 1}};
    const auto small = [](int power) {
        const float by = std::ldexp(1.0f, power);
        return scene_of({{{-by, -by, by}, {by, -by, by}, {0, by, by}}});
    };
    auto earth = std::make_shared<Mesh>(icosphere(3));
    for (Vec3f& vertex : earth->vertices) vertex = vertex * 6.371e6f;
    const Scene earth_scene{.objects = {object(std::shared_ptr<const Mesh>(earth))}};
    const Vec3f moon(0, 0, 3.844e8f);
    const double surface =
        make_accelerator("list", earth_scene)->closest({moon, {0, 0, -1}}, *std::make_unique<Traversal>())->t;
    for (const auto& [name, scene, ray, t] :
         {Still{"slow", scene_of({across}), {{0, 0.5f, 0}, {0, 0, 0x1p-30f}}, 0x1p30},
          Still{"slower than floats divide by", scene_of({across}), {{0, 0.5f, 0}, {0, 0, 0x1p-140f}}, 0x1p140},
          Still{"small", small(-90), {{0, 0, 0}, {0, 0, 1}}, 0x1p-90},
          Still{"smaller than any float squared", small(-120), {{0, 0, 0}, {0, -0.0f, 0x1p-60f}}, 0x1p-60},
          Still{"from the Moon", earth_scene, {moon, {0, 0, -1}}, surface}}) {
        for (const std::string& structure : accelerator_names()) {
            INFO(structure << ", " << name);
            const auto accelerator = make_accelerator(structure, scene);
            Traversal traversal;
            const auto hit = accelerator->closest(ray, traversal);
            REQUIRE(hit);
            CHECK(hit->t == t);
            CHECK(accelerator->occluded(ray, traversal));
        }
    }
}

TEST_CASE("a ray without direction hits nothing, whichever structure is asked and however") {
    const Scene scene{
        .objects = {
            object(Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}), object(Triangle{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}),
            object(Triangle{{1, -1, -1}, {1, 1, -1}, {1, 0, 1}}), object(Triangle{{-1, 1, -1}, {1, 1, -1}, {0, 1, 1}}),
            object(Sphere{{0, 0, 0}, 1}), object(Sphere{{0, 0, 5}, 1}), object(Plane{{0, 0, 0}, {0, 0, 1}}),
            object(Cylinder{{0, 0, -1}, {0, 0, 1}, 1, Ends::capped}), object(Disk{{0, 0, 0}, {0, 0, 1}, 2})}};
    for (const std::string& name : accelerator_names())
        for (const Vec3f& direction : {Vec3f(0), Vec3f(-0.0f)})
            for (const Vec3f& origin : {Vec3f(0), Vec3f(0, 0, 1), Vec3f(0, 0, 5), Vec3f(1, 0, 0), Vec3f(0, 0, -40)})
                for (const Interval<float> range : {Ray{}.range, Interval<float>{-1, 1}}) {
                    INFO(name << " from " << adversarial::words(origin));
                    const auto accelerator = make_accelerator(name, scene);
                    const Ray ray{origin, direction, range};
                    Traversal traversal;
                    CHECK_FALSE(accelerator->closest(ray, traversal));
                    CHECK_FALSE(accelerator->occluded(ray, traversal));
                    const std::array<Ray, 5> rays{ray, ray, ray, ray, ray};
                    for (const auto& hit : accelerator->closest_of(rays, traversal)) CHECK_FALSE(hit);
                }
}

TEST_CASE("a hit whose t is beyond the floats is a hit") {
    const Scene scene =
        scene_of({{{-0x1p100f, -0x1p100f, 0x1p90f}, {0x1p100f, -0x1p100f, 0x1p90f}, {0, 0x1p100f, 0x1p90f}}});
    const Ray ray{{0, 0, 0}, {0, 0, 0x1p-149f}};
    for (const std::string& name : accelerator_names()) {
        INFO(name);
        const auto accelerator = make_accelerator(name, scene);
        Traversal traversal;
        const auto hit = accelerator->closest(ray, traversal);
        REQUIRE(hit);
        CHECK(hit->t == 0x1p239);
        CHECK(accelerator->occluded(ray, traversal));
    }
}

TEST_CASE("what is far away from a ray that starts near is hit as the list says, however far and fast") {
    Draw draw(12);
    const std::vector<Triangle> near = soup(draw, 200, 2);
    for (int power = 36; power < 124; power += 3) {
        const float by = std::ldexp(1.0f, power);
        std::vector<Triangle> far;
        for (const auto& [a, b, c] : near) far.push_back({a * by, b * by, c * by});
        const Scene scene = scene_of(far);
        const auto list = make_accelerator("list", scene);
        for (const std::string& name : accelerator_names()) {
            INFO(name << ", 2^" << power);
            const auto tree = make_accelerator(name, scene);
            const auto judge = [&](Draw& drawn) -> std::optional<std::string> {
                const float speed = std::ldexp(1.0f, drawn.integer(-58, 38));
                const Ray ray{drawn.in_cube(1) * std::ldexp(1.0f, drawn.integer(0, 38)), drawn.in_cube(1) * speed};
                Traversal traversal;
                const auto hit = list->closest(ray, traversal);
                const bool is_right =
                    same(hit, tree->closest(ray, traversal)) && tree->occluded(ray, traversal) == hit.has_value();
                return is_right ? std::nullopt : std::optional(adversarial::words(ray));
            };
            CHECK(faults(300, judge) == "");
        }
    }
}

TEST_CASE("a ray whose range is empty hits nothing, wherever that ends") {
    const Scene scene{.objects = {object(std::make_shared<const Mesh>(icosphere(4)))}};
    for (const std::string& name : accelerator_names()) {
        INFO(name);
        const auto accelerator = make_accelerator(name, scene);
        for (const Interval<float> range : {Interval<float>{0, -1}, {3, 2}, {0, -0x1p100f}}) {
            Traversal traversal;
            const Ray ray{{0, 0, 3}, {0.01f, 0.02f, -1}, range};
            CHECK_FALSE(accelerator->closest(ray, traversal));
            CHECK_FALSE(accelerator->occluded(ray, traversal));
        }
    }
}

TEST_CASE("a range that ends at -0 is as one that ends at 0, and so is a ray that a hit at -0 has ended") {
    // Triangles of one plane through the ray's origin, in many leaves: each is hit at 0, the first one counts.
    Draw draw(1);
    const auto corner = [&](double angle) {
        const double size = draw.number(3, 60);
        const float x = cast<float>(std::round(size * std::cos(angle))),
                    y = cast<float>(std::round(size * std::sin(angle)));
        return Vec3f(x, y, x + 2 * y);
    };
    std::vector<Triangle> triangles;
    for (int i = 0; i < 200; ++i) {
        const double angle = draw.number(0, 6);
        triangles.push_back({corner(angle), corner(angle + 2), corner(angle + 4)});
    }
    const Scene scene = scene_of(triangles);
    for (const std::string& name : accelerator_names()) {
        const auto structure = make_accelerator(name, scene);
        for (const float end : {std::numeric_limits<float>::infinity(), 0.0f, -0.0f})
            for (const float start : {0.0f, -0.0f})
                for (const float sense : {1.0f, -1.0f}) {
                    INFO(name << ", from " << start << " to " << end << ", along " << sense);
                    Traversal traversal;
                    const Ray ray{{0, 0, 0}, Vec3f(0.25f, 0.5f, 2) * sense, {start, end}};
                    const auto hit = structure->closest(ray, traversal);
                    CHECK((hit && hit->t == 0 && hit->primitive.part == 0));
                    CHECK(structure->occluded(ray, traversal));
                }
    }
}

TEST_CASE("an unknown accelerator is refused by a line that names the known ones") {
    CHECK_THROWS_WITH(make_accelerator("bhv", {}),
                      "expected an accelerator (" + accelerator_list() + "), found \"bhv\"");
}

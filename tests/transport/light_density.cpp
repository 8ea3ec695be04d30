#include "catch.h"
#include "sampling/direction_cells.h"
#include "transport/lights.h"

#include "raylab/base/error.h"
#include "raylab/geometry/intersect/nearest.h"
#include "raylab/geometry/placement_at.h"
#include "raylab/geometry/shape_parts.h"

#include <array>
#include <vector>

using namespace raylab;
using namespace raylab::lights;

namespace {

constexpr std::uint64_t samples = 10'000;
constexpr double alpha = 1e-7;  // of some forty tests

// What a ray meets first; rays decide exactly, and share nothing with the samplers.
std::optional<std::pair<Primitive, Vec3d>> first_hit(const Scene& scene, const Vec3d& from, const Vec3d& direction) {
    const Ray ray{convert<float>(from), convert<float>(direction)};
    Nearest nearest(ray);
    DecisionCounts decisions;
    const auto target_of = [&](Primitive primitive) -> Target {
        const Object& object = scene.objects[primitive.object];
        return {&object.shape, primitive.part, &object.placement, object.sides};
    };
    for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&scene.objects[number].shape);
        const auto parts = static_cast<std::uint32_t>(mesh ? (*mesh)->faces.size() : 1);
        for (std::uint32_t part = 0; part < parts; ++part) {
            if (const auto found = intersect(ray, target_of({number, part}), decisions))
                nearest.offer(*found, {number, part}, target_of, decisions);
        }
    }
    const auto hit = nearest.hit();
    if (!hit) return std::nullopt;
    return std::pair{hit->primitive, from + hit->t * convert<double>(convert<float>(direction))};
}

// The samples that are seen, in cells of direction, against the density that the lights tell of what rays meet there.
double p_value(const Scene& scene, const Vec3d& from) {
    const AreaLights lights(scene);
    DirectionCells cells(-1, 32, 24);
    for (std::uint64_t i = 0; i < samples; ++i) {
        RandomSequence random(71, i);
        const double u = random.next(), v = random.next();
        const auto light = lights.sample(from, random.next(), {u, v});
        const auto hit = light ? first_hit(scene, from, light->direction) : std::nullopt;
        if (hit && glm::length(hit->second - light->point) < 1e-4 * light->distance)
            cells.add(light->direction);
        else
            cells.add_none();
    }
    const auto integrals = cells.integrals([&](const Vec3d& direction) {
        const auto hit = first_hit(scene, from, direction);
        return hit ? lights.pdf(from, hit->first, hit->second) : 0;
    });
    CHECK_THAT(integrals.back(), WithinAbs(cells.share_of_none(), 0.025));  // five standard errors of a half
    return cells.p_value(integrals);
}

const std::vector<Shape> shapes{
    Sphere{{0.5f, 0, 1.5f}, 1},
    Ellipsoid{{0, 0.5f, 2}, {1, 0.5f, 1.5f}},
    Disk{{0, 0.25f, 1}, {1, 1, -2}, 1.5f},
    Annulus{{0, 0, 1}, {0, 1, -2}, 0.75f, 1.5f},
    Triangle{{1, 0, 1}, {-1, 1, 2}, {0, -2, 1.5f}},
    Polygon{{{-1, -1, 1}, {2, -1, 1}, {2, 1, 1}, {-1, 1, 1}}},
    Polygon{{{-1, -1, 1}, {2, -1, 1}, {3, 1, 1}, {0, 0, 1}, {-1, 1, 1}}},
    std::make_shared<const Mesh>(
        Mesh{.vertices = {{-1, 0, 1}, {1, 0, 1}, {0, 1, 2}, {0, -1, 2}}, .faces = {{0, 1, 2}, {1, 0, 3}}})};

const Affine sheared{.columns = {Vec3f{1, 0.25f, 0}, Vec3f{0.5f, 1.5f, 0}, Vec3f{0, 0.25f, -0.75f}},
                     .translation = {0.25f, 0, 2}};

}  // namespace

TEST_CASE("samples of any light have the density that its pdf tells of what a ray meets, placed or not", "[long]") {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        INFO(i);
        CHECK(p_value(lit_by(shapes[i]), {0, 0, 0}) > alpha);
        CHECK(p_value(lit_by(shapes[i]), {0.4, 0.3, 4}) > alpha);  // from behind
        CHECK(p_value(lit_by(shapes[i], sheared), {0, 0, 0}) > alpha);
    }
    CHECK(p_value(lit_by(Sphere{{0, 0, 0}, 2}), {1, 0.5, 0}) > alpha);                 // inside
    CHECK(p_value(lit_by(Sphere{{0, 0, 3}, 2}, {}, Sides::back), {0, 0, 0}) > alpha);  // only its far wall is seen
}

// The moment's placement is exact in floats, and what rests there is judged by its rays above.
TEST_CASE("a light that turns and stretches has the points and the density of one that rests where it is") {
    const Affine placement{.columns = {Vec3f{1, 0.25f, 0}, Vec3f{0.5f, 1.5f, 0}, Vec3f{0, 0.25f, -0.75f}},
                           .translation = {0.25f, 0, 2}};
    const Motion motion{.columns = {Vec3f{0, 0.5f, 0}, Vec3f{-0.5f, 0, 0.25f}, Vec3f{0.25f, 0, 0}},
                        .translation = {0, 0.5f, 1}};
    constexpr float time = 0.5f;
    for (const Shape& shape : shapes) {
        if (as_mesh(shape)) continue;  // its triangles are chosen by their areas at time 0
        Scene moving = lit_by(shape, placement);
        moving.camera.shutter = Shutter{0, 1};
        moving.objects[0].motion = motion;
        const AreaLights moves(moving), rests(lit_by(shape, rounded_placement(placement, motion, time)));
        const bool is_polygon = std::holds_alternative<Polygon>(shape);  // a sheared rectangle is two triangles
        int found = 0;
        for (std::uint64_t i = 0; i < 100; ++i) {
            RandomSequence random(83, i);
            const double choice = 0.999 * random.next(), u = random.next();
            const std::array numbers{u, random.next()};
            const auto there = moves.sample({0, 0, 0}, choice, numbers, time);
            const auto here = rests.sample({0, 0, 0}, choice, numbers);
            if (!there) continue;
            ++found;
            CHECK_THAT(rests.pdf({0, 0, 0}, there->primitive, there->point), WithinRel(there->pdf, 1e-6));
            CHECK_THAT(moves.pdf({0, 0, 0}, there->primitive, there->point, time), WithinRel(there->pdf, 1e-6));
            if (!is_polygon) CHECK(glm::length(there->point - here->point) < 1e-9);
        }
        CHECK(found == 100);
    }
}

TEST_CASE("several lights, of which a weak one is near: the choice is part of the density") {
    Scene scene = lit_by(shapes[0]);
    scene.materials.push_back(Material{.name = "weak", .emission = Color(1e-6)});
    scene.objects.push_back(Object{.shape = Triangle{{-1, -1, -1}, {0, -1, -1}, {-1, 0, -1}}, .front = 1, .back = 1});
    scene.objects.push_back(Object{.shape = Polygon{{{2, 2, 0}, {2, 3, 0}, {2, 3, 1}, {2, 2, 1}}}});
    CHECK(p_value(scene, {0, 0, 0}) > alpha);
    const AreaLights lights(scene);
    int weak = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto light = lights.sample({0, 0, 0}, (i + 0.5) / 1000, {0.3, 0.6});
        weak += light && light->primitive.object == 1;
    }
    CHECK(weak == 42);  // a third of an eighth
}

TEST_CASE("a light that shines on one side is dark on the other") {
    const Polygon square{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};  // its normal is z
    const AreaLights front(lit_by(square, {}, Sides::front)), back(lit_by(square, {}, Sides::back));
    const Vec3d above{0.5, 0.5, 3}, below{0.5, 0.5, 0};
    CHECK((front.sample(above, 0.5, {0.5, 0.5}) && !front.sample(below, 0.5, {0.5, 0.5})));
    CHECK((back.sample(below, 0.5, {0.5, 0.5}) && !back.sample(above, 0.5, {0.5, 0.5})));
    const Affine mirrored{.columns = {Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, -1}}, .translation = {0, 0, 2}};
    const AreaLights turned(lit_by(square, mirrored, Sides::front));  // its normal is -z now
    CHECK((turned.sample(below, 0.5, {0.5, 0.5}) && !turned.sample(above, 0.5, {0.5, 0.5})));
}

TEST_CASE("no light shines on points of its own plane, nor a sphere on points outside that touch it") {
    const Polygon square{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    for (const Shape& flat :
         {Shape{square}, Shape{Triangle{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}, Shape{Disk{{0, 0, 1}, {0, 0, 1}, 1}}}) {
        const AreaLights lights(lit_by(flat));
        for (const Vec3d& from : {Vec3d{0.25, 0.25, 1}, Vec3d{0.25, 0.25, 1 + 1e-9}, Vec3d{5, 0, 1}}) {
            CHECK_FALSE(lights.sample(from, 0.5, {0.3, 0.4}));
            CHECK(lights.pdf(from, {}, {0.2, 0.2, 1}) == 0);
        }
    }
    const AreaLights sphere(lit_by(Sphere{{0, 0, 0}, 1}));
    for (std::uint64_t i = 0; i < 100; ++i) {
        RandomSequence random(73, i);
        const auto light = sphere.sample({0, 0, 1}, 0.5, {random.next(), random.next()});
        CHECK((!light || light->direction.z < 0));
    }
}

TEST_CASE("a light of no area is refused, and what cannot be sampled is named") {
    CHECK_THROWS_WITH(AreaLights(lit_by(Triangle{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}})),
                      Catch::Contains("expected a light of finite area, found one of no area"));
    CHECK_THROWS_AS(AreaLights(lit_by(Disk{{0, 0, 0}, {0, 0, 1}, 0})), Error);
    const AreaLights tube(lit_by(Cylinder{{0, 0, 0}, {0, 0, 1}, 0.1f}));
    CHECK((tube.empty() && tube.unsampled() == std::vector<std::string>{"light"}));
    CHECK(tube.pdf({1, 0, 0}, {0, 0}, {0.1, 0, 0}) == 0);
    CHECK_FALSE(tube.sample({1, 0, 0}, 0.5, {0.5, 0.5}));
    Scene moving = lit_by(Sphere{{0, 0, 0}, 1});
    moving.camera.shutter = Shutter{0, 1};
    moving.objects[0].motion = Motion{.translation = {1, 0, 0}};
    CHECK(AreaLights(moving).unsampled().empty());
    moving.objects[0].motion->columns[0].x = 1;
    CHECK(AreaLights(moving).unsampled().empty());
    Scene dark = lit_by(Sphere{{0, 0, 0}, 1});
    dark.materials[0].emission = Color(0);
    CHECK((AreaLights(dark).empty() && AreaLights(dark).unsampled().empty()));
}

TEST_CASE("a tiny light, sampled by area because its solid angle has lost digits, is as right") {
    const float size = 1e-4f;
    const AreaLights lights(lit_by(Polygon{{{0, 0, 1}, {size, 0, 1}, {size, size, 1}, {0, size, 1}}}));
    const auto [mean, error] = irradiance_over_pi(lights, {0, 0, 0}, {0, 0, 1}, 10'000);
    CHECK_THAT(mean, WithinRel(double{size} * size / std::numbers::pi, 1e-7));
}

#include "accelerator/scenes.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/accelerator.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

struct NamedScene {
    std::string name;
    Scene scene;
};

std::vector<Triangle> copies(const std::vector<Triangle>& triangles, std::size_t count) {
    std::vector<Triangle> result;
    for (std::size_t i = 0; i < count; ++i) result.insert(result.end(), triangles.begin(), triangles.end());
    return result;
}

std::vector<Triangle> degenerate(Draw& draw) {
    std::vector<Triangle> triangles = soup(draw, 50, 2);
    for (std::size_t i = 0; i < triangles.size(); i += 2) triangles[i].c = i % 4 == 0 ? triangles[i].a : triangles[i].b;
    return triangles;
}

std::vector<Triangle> far_apart(Draw& draw) {  // centers so spread that splitting in the middle never helps
    std::vector<Triangle> triangles;
    for (int i = -140; i < 120; ++i) {
        const float x = std::ldexp(1.0f, i);
        triangles.push_back({{x, 0, 0}, {x * 1.5f, x, 0}, {x, 0, x * draw.uniform(0.5f, 1)}});
    }
    return triangles;
}

std::vector<NamedScene> scenes() {
    Draw draw(7);
    std::vector<NamedScene> result;
    const auto add = [&](const std::string& name, Scene scene) { result.push_back({name, std::move(scene)}); };
    add("empty", {});
    add("one triangle", scene_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
    add("one plane", {.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}})}});
    add("soup", scene_of(soup(draw, 300, 2)));
    add("floor", scene_of(floor_of(8)));
    add("duplicates", scene_of(copies(soup(draw, 15, 2), 20)));
    add("degenerate", scene_of(degenerate(draw)));
    add("at 1e6", scene_of(soup(draw, 100, 2, Vec3f(1e6f))));
    add("tiny", scene_of(soup(draw, 100, 1e-20f)));
    add("huge", scene_of(soup(draw, 100, 1e20f)));
    add("far apart", scene_of(far_apart(draw)));
    for (int i = 0; i < 6; ++i) add("all shapes " + std::to_string(i), any_scene(draw, i < 3 ? 5 : 60));
    return result;
}

// A vertex of the scene, where there is one.
Vec3d some_target(Draw& draw, const Scene& scene) {
    if (scene.objects.empty()) return Vec3d(0);
    const Object& target = scene.objects[static_cast<std::size_t>(draw.integer(0, static_cast<int>(scene.objects.size()) - 1))];
    if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&target.shape)) {
        const auto& faces = (*mesh)->faces;
        const Triangle t = (*mesh)->triangle(static_cast<std::size_t>(draw.integer(0, static_cast<int>(faces.size()) - 1)));
        const Vec3d a = convert<double>(t.a), b = convert<double>(t.b), c = convert<double>(t.c);
        if (draw.one_in(3)) return a;
        return draw.one_in(2) ? (a + b) / 2.0 : (a + b + c) / 3.0;
    }
    return transform_point(target.placement, convert<double>(any_point(draw)));
}

double extent(const Scene& scene) {
    const auto* mesh = scene.objects.empty() ? nullptr : std::get_if<std::shared_ptr<const Mesh>>(&scene.objects[0].shape);
    return mesh ? std::max(1e-30, glm::length(convert<double>((*mesh)->vertices[0]))) : 3;
}

Ray any_ray(Draw& draw, const Scene& scene) {
    const Vec3d target = some_target(draw, scene);
    Ray ray = through(convert<float>(target + convert<double>(draw.in_cube(3)) * extent(scene)), target);
    switch (draw.integer(0, 5)) {
        case 0: ray.direction[draw.integer(0, 2)] = draw.one_in(2) ? 0.0f : -0.0f; break;
        case 1: ray = {convert<float>(target), draw.lattice_direction(1)}; break;                   // from a vertex, often in a face
        case 2: ray = {draw.on_lattice(-9, 9), draw.lattice_direction(1)}; break;                   // in planes of boxes
        case 3: ray.origin = convert<float>(target - convert<double>(ray.direction) * 1e3); break;  // from afar
        default: break;
    }
    if (ray.direction == Vec3f(0)) ray.direction = {0, 0, 1};
    return ray;
}

std::string words(const std::optional<Hit>& hit) {
    return hit ? fmt::format("{}/{} at {:a}", hit->primitive.object, hit->primitive.part, hit->t) : "nothing";
}

bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (!a || !b) return !a && !b;
    return a->primitive == b->primitive && a->t == b->t && a->u == b->u && a->v == b->v;
}

struct NamedStructure {
    std::string name;
    std::unique_ptr<Accelerator> accelerator;
};

std::vector<NamedStructure> structures_of(const Scene& scene) {
    std::vector<NamedStructure> structures;
    for (const std::string& name : accelerator_names()) structures.push_back({name, make_accelerator(name, scene)});
    return structures;
}

// One ray, which the list answers once and every structure then.
std::optional<std::string> compare_one(Draw& draw, const Scene& scene, const Accelerator& list,
                                       const std::vector<NamedStructure>& structures) {
    Ray ray = any_ray(draw, scene);
    Traversal traversal;
    std::optional<Hit> expected = list.closest(ray, traversal);
    if (expected && draw.one_in(3)) ray.range = tight_range(draw, cast<float>(expected->t));
    if (expected && draw.one_in(3)) ray.leaving = expected->primitive;
    expected = list.closest(ray, traversal);
    for (const auto& [name, structure] : structures) {
        const auto given = structure->closest(ray, traversal);
        if (!same(expected, given))
            return fmt::format("{} says {} instead of {}: {}", name, words(given), words(expected), adversarial::words(ray));
        if (structure->occluded(ray, traversal) != expected.has_value())
            return name + ": occluded() denies closest(): " + adversarial::words(ray);
    }
    return std::nullopt;
}

oracle::Answer meet_object(const Ray& ray, const Object& object) {
    return oracle::meet(in<double>(ray), object.shape, object.placement, object.sides);
}

// The first of the objects along the ray, the lowest among equals.
std::optional<std::uint32_t> first_object(const Ray& ray, const Scene& scene) {
    std::optional<std::uint32_t> first;
    std::optional<oracle::ExactT> least;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const auto answer = meet_object(ray, scene.objects[i]);
        if (!answer.hit() || (least && is_gteq(answer.t->compare(*least)))) continue;
        first = i;
        least = answer.t;
    }
    return first;
}

}  // namespace

TEST_CASE("every structure answers as the list does: same primitive, same bits of t") {
    for (const auto& [name, scene] : scenes()) {
        const auto list = make_accelerator("list", scene);
        const auto structures = structures_of(scene);
        INFO(name);
        CHECK(faults(4'000, [&](Draw& draw) { return compare_one(draw, scene, *list, structures); }) == "");
    }
}

TEST_CASE("the first hit is the oracle's, and of equal ones the lowest") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        Scene scene = any_scene(draw, 4);
        if (draw.one_in(2)) scene.objects.push_back(scene.objects[0]);  // a tie with the first
        const auto list = make_accelerator("list", scene);
        const Ray ray = any_ray(draw, scene);
        Traversal traversal;
        const auto given = list->closest(ray, traversal);
        const auto first = first_object(ray, scene);
        if (given.has_value() != first.has_value() || (given && given->primitive.object != *first)) {
            return fmt::format("{} instead of object {}: {}", words(given), first ? static_cast<int>(*first) : -1, adversarial::words(ray));
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
            triangles.push_back({a, b, point * 3.0f - a - b});  // exact: 24 bits are enough
        }
        const Scene scene = scene_of(triangles);
        const auto list = make_accelerator("list", scene), tree = make_accelerator("aabb_tree", scene);
        const Ray ray{origin, point - origin, {0.5f, 2}};
        Traversal traversal;
        const auto hit = list->closest(ray, traversal), again = tree->closest(ray, traversal);
        const bool right = hit && hit->primitive == Primitive{0, 0} && same(hit, again);
        return right ? std::nullopt : std::optional(fmt::format("{} and {}: {}", words(hit), words(again), adversarial::words(ray)));
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

TEST_CASE("an unknown accelerator is refused by a line that names the known ones") {
    CHECK_THROWS_WITH(make_accelerator("bvh", {}), "expected an accelerator (" + accelerator_list() + "), found \"bvh\"");
}

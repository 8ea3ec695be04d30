#include "raylab/accelerator/ray_space/ray_space.h"

#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

Scene any_space_scene(Draw& draw) {
    switch (draw.integer(0, 4)) {
        case 0:
            return scene_of(floor_of(8));
        case 1:
            return scene_of(soup(draw, 60, 2));
        case 2:
            return {};
        default:
            return any_scene(draw, draw.integer(1, 30));
    }
}

// A ray from one of a few places, like a picture's rays, or from anywhere; half of the directions are on the borders of
// faces.
Ray any_space_ray(Draw& draw, const std::vector<Vec3f>& places) {
    const bool from_place = draw.one_in(2);
    const Vec3f origin = from_place ? places[static_cast<std::size_t>(draw.integer(0, 2))] : any_point(draw);
    Ray ray{origin, draw.one_in(2) ? draw.lattice_direction(2) : any_point(draw) - origin};
    if (ray.direction == Vec3f(0)) ray.direction = {0, 0, 1};
    if (draw.one_in(8)) ray.direction *= 1e-3f;
    if (draw.one_in(8)) ray.range = {draw.uniform(-1, 1), draw.uniform(0, 4)};
    return ray;
}

std::optional<std::string> compare_space(Draw& draw) {
    const Scene scene = any_space_scene(draw);
    const std::vector<Vec3f> places{any_point(draw) * 2.0f, any_point(draw), draw.on_lattice(-3, 3)};
    std::vector<Ray> rays;
    for (int i = 0; i < 300; ++i) rays.push_back(any_space_ray(draw, places));
    const auto list = make_accelerator("list", scene);
    const auto expected = std::span(rays).first(static_cast<std::size_t>(draw.integer(0, 200)));
    const RaySpace space(scene, expected, *list,
                         {.few_items = 1, .few_rays = static_cast<std::size_t>(draw.integer(0, 4))});
    Traversal traversal;
    for (Ray& ray : rays) {
        const auto hit = list->closest(ray, traversal);
        if (hit && draw.one_in(4)) ray.range = tight_range(draw, cast<float>(hit->t));
        const auto truth = list->closest(ray, traversal);
        if (!same(truth, space.closest(ray, traversal))) return words(ray);
        if (space.occluded(ray, traversal) != truth.has_value()) return "occluded() denies closest(): " + words(ray);
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("ray space answers as the list does, rays that were expected and others") {
    CHECK(faults(2'000, compare_space) == "");
}

TEST_CASE("a ray that was expected finds a short list") {
    Draw draw(5);
    const Scene scene = scene_of(soup(draw, 500, 2));
    std::vector<Ray> rays;
    for (int i = 0; i < 1000; ++i) rays.push_back({{0, 0, 9}, draw.in_cube(0.2) + Vec3f(0, 0, -1)});
    const auto list = make_accelerator("list", scene);
    const RaySpace space(scene, rays, *list);
    Traversal traversal;
    for (const Ray& ray : rays) space.closest(ray, traversal);
    CHECK(traversal.primitive_tests < 12 * rays.size());
}

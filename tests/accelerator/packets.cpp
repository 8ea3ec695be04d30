#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bvh/box_packet.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/scene/camera.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

Scene any_packet_scene(Draw& draw) {
    switch (draw.integer(0, 5)) {
        case 0:
            return scene_of(floor_of(8));
        case 1:
            return scene_of(soup(draw, 100, 2));
        case 2:
            return scene_of(soup(draw, 100, 1e20f));
        case 3:
            return scene_of({});
        default:
            return any_scene(draw, draw.integer(1, 30));
    }
}

// Rays that are more or less coherent: about a direction that now and then is an axis, so that some rays go the other
// way along it.
std::vector<Ray> any_packet(Draw& draw, float extent) {
    const Vec3f origin = draw.one_in(2) ? any_point(draw) * 3.0f : draw.on_lattice(-3, 3), toward = any_point(draw);
    const float spread = std::ldexp(1.0f, -draw.integer(0, 10)), moved = draw.one_in(2) ? 0.0f : spread;
    std::vector<Ray> rays;
    const int count = draw.integer(1, 150);
    for (int i = 0; i < count; ++i) {
        Ray ray{(origin + draw.in_cube(1) * moved) * extent, toward - origin + draw.in_cube(1) * spread};
        if (ray.direction == Vec3f(0)) ray.direction = {0, 0, 1};
        if (draw.one_in(4)) ray.range = {draw.uniform(-0.1f, 1), draw.uniform(0, 4) * extent};
        rays.push_back(ray);
    }
    return rays;
}

std::optional<std::string> compare_packet(Draw& draw) {
    const Scene scene = any_packet_scene(draw);
    const bool huge =
        !scene.objects.empty() && bounds(scene.objects[0].shape) && bounds(scene.objects[0].shape)->max.x > 1e10f;
    const auto rays = any_packet(draw, huge ? 1e20f : 1.0f);
    const auto list = make_accelerator("list", scene);
    for (const std::string& name : accelerator_names()) {
        Traversal traversal;
        const auto hits = make_accelerator(name, scene)->closest_of(rays, traversal);
        if (hits.size() != rays.size()) return "an answer is missing";
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (!same(hits[i], list->closest(rays[i], traversal))) return name + ": " + words(rays[i]);
    }
    return std::nullopt;
}

// A box, often one that touches the rays' origin.
Box any_box(Draw& draw) {
    const Vec3f a = any_point(draw), b = any_point(draw);
    return unite({a, a}, {b, b});
}

std::optional<std::string> compare_box(Draw& draw) {
    const auto rays = any_packet(draw, 1);
    if (!BoxPacket::fits(rays)) return std::nullopt;
    const std::vector<BoxRay> box_rays(rays.begin(), rays.end());
    double end = 0;
    for (const BoxRay& ray : box_rays) end = std::max(end, ray.end());
    const BoxPacket packet(box_rays);
    const Box box = any_box(draw);
    BoxTree::Planes planes;
    for (std::size_t plane = 0; plane < 6; ++plane) {
        const auto axis = static_cast<int>(plane % 3);
        planes[plane].fill(plane < 3 ? box.min[axis] : box.max[axis]);
    }
    std::size_t hit_found = 0;
    for (const BoxRay& ray : box_rays) hit_found += ray.reaches(ray.entries(planes)[1]);
    const auto said = packet.rays_hitting(planes, 1, end);
    if (said == BoxPacket::RaysHitting::none && hit_found > 0)
        return "none of the rays is said to hit a box that some hit";
    return std::nullopt;
}

}  // namespace

TEST_CASE("rays asked together have the answers of rays asked alone") { CHECK(faults(400, compare_packet) == ""); }

TEST_CASE("what a packet is said to miss, each of its rays misses") { CHECK(faults(100'000, compare_box) == ""); }

TEST_CASE("a packet saves box tests where its rays stay together") {
    Draw draw(3);
    const Scene scene = scene_of(soup(draw, 2000, 2));
    const auto tree = make_accelerator("bvh", scene);
    const CameraFrame frame = camera_frame({.position = {1, 2, 12}, .target = {0.3, 0.2, 0}}, {800, 800});
    std::vector<Ray> rays;
    for (int i = 0; i < 64; ++i) rays.push_back(eye_ray(frame, 300.5 + i % 8, 300.5 + i / 8));
    Traversal alone, together;
    for (const Ray& ray : rays) tree->closest(ray, alone);
    tree->closest_of(rays, together);
    CHECK(2 * together.box_tests < alone.box_tests);
    CHECK(8 * together.steps < alone.steps);
}

#include "raylab/accelerator/item_buffer/item_buffer.h"

#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/base/error.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// The camera often looks along an axis, so that edges project to the borders of pixels.
Camera any_camera(Draw& draw, double extent) {
    Camera camera;
    const auto at = [&] { return convert<double>(any_point(draw)) * extent; };
    camera.position = at() * (draw.one_in(4) ? 1e4 : draw.one_in(2) ? 2.0 : 1.0);
    camera.target = draw.one_in(2) ? camera.position + convert<double>(draw.lattice_direction(1)) * extent : at();
    if (camera.target == camera.position) camera.target.x += extent;
    camera.up = draw.one_in(2) ? Vec3d{0, 1, 0.01} : convert<double>(draw.in_cube(1));
    constexpr std::array angles{1e-3, 1.0, 40.0, 53.13010235415598, 90.0, 120.0, 179.0, 179.999999};
    if (draw.one_in(3))
        camera.projection = Orthographic{extent * (draw.one_in(3) ? 1e-3 : draw.number(0.5, 12))};
    else
        camera.projection = Perspective{angles[static_cast<std::size_t>(draw.integer(0, 7))]};
    return camera;
}

ImageSize any_size(Draw& draw) {
    constexpr std::array sizes{ImageSize{1, 1}, ImageSize{8, 8}, ImageSize{7, 5}, ImageSize{64, 48}, ImageSize{3, 90}};
    return sizes[static_cast<std::size_t>(draw.integer(0, 4))];
}

std::optional<CameraFrame> any_frame(Draw& draw, double extent) {
    try {
        return camera_frame(any_camera(draw, extent), any_size(draw));
    } catch (const Error&) {
        return std::nullopt;  // up is parallel to the view
    }
}

struct Sized {
    Scene scene;
    double extent;
};

Sized any_sized_scene(Draw& draw) {
    switch (draw.integer(0, 7)) {
        case 0:
            return {scene_of(floor_of(8)), 3};
        case 1:
            return {scene_of(soup(draw, 40, 2)), 1};
        case 2:
            return {scene_of(soup(draw, 40, 1e-20f)), 1e-20};
        case 3:
            return {scene_of(soup(draw, 40, 1e20f)), 1e20};
        case 4:
            return {scene_of(soup(draw, 40, 2, Vec3f(1e6f))), 1e6};
        case 5:
            return {{}, 1};
        default:
            return {any_scene(draw, draw.integer(1, 20)), 1};
    }
}

// An eye ray, in half of the cases through a border between pixels.
Ray any_eye_ray(Draw& draw, const CameraFrame& frame) {
    const auto along = [&](int side) {
        return draw.one_in(2) ? draw.integer(0, 2 * side) * 0.5 : draw.number(0, side);
    };
    Ray ray = eye_ray(frame, along(frame.image.width), along(frame.image.height));
    if (draw.one_in(10)) ray.direction = draw.any_direction();
    if (draw.one_in(10)) ray.origin = any_point(draw);
    return ray;
}

std::string words(const std::optional<Hit>& hit) {
    return hit ? fmt::format("{}/{} at {:a}", hit->primitive.object, hit->primitive.part, hit->t) : "nothing";
}

std::optional<std::string> compare_view(Draw& draw) {
    const auto [scene, extent] = any_sized_scene(draw);
    const auto frame = any_frame(draw, extent);
    if (!frame) return std::nullopt;
    const auto list = make_accelerator("list", scene), tree = make_accelerator("bvh", scene);
    const ItemBuffer buffer(scene, *frame, *tree, {.threads = draw.integer(1, 3)});
    for (int i = 0; i < 200; ++i) {
        Ray ray = any_eye_ray(draw, *frame);
        Traversal traversal;
        auto expected = list->closest(ray, traversal);
        if (expected && draw.one_in(5)) ray.range = tight_range(draw, cast<float>(expected->t));
        if (expected && draw.one_in(5)) ray.leaving = expected->primitive;
        expected = list->closest(ray, traversal);
        const auto given = buffer.closest(ray, traversal);
        if (!same(expected, given))
            return fmt::format("{} instead of {}: {}", words(given), words(expected), adversarial::words(ray));
        if (buffer.occluded(ray, traversal) != expected.has_value())
            return "occluded() denies closest(): " + adversarial::words(ray);
    }
    return std::nullopt;
}

// A direction of length approximately 1 whose components multiplied by three and five are floats, too.
Vec3f short_direction(Draw& draw) {
    const Vec3d unit = glm::normalize(convert<double>(draw.in_cube(1)) + Vec3d(0, 0, 1e-3));
    return convert<float>(glm::round(unit * 0x1p21) * 0x1p-21);
}

// A triangle, or a rectangle whose corners are those of its box, with a corner here.
Object with_corner_at(const Vec3f& corner, Draw& draw) {
    if (draw.one_in(2)) return object(Triangle{corner, corner + draw.in_cube(1), corner + draw.in_cube(1)});
    Vec3f along(0), across(0);
    const int axis = draw.integer(0, 2);
    along[axis] = draw.in_cube(1).x;
    across[(axis + 1) % 3] = draw.in_cube(1).x;
    return object(Polygon{{corner, corner + along, corner + along + across, corner + across}});
}

// The ray goes exactly, up to its own rounding, through a corner where four pixels touch, and exactly through a
// primitive's corner.
std::optional<std::string> compare_touched(Draw& draw) {
    const Vec3f direction = short_direction(draw);
    const bool parallel = draw.one_in(2);
    const Vec3f eye = parallel ? Vec3f(0) : draw.on_lattice(-1, 1);
    Camera camera{.position = convert<double>(eye),
                  .target = convert<double>(eye + direction),
                  .up = convert<double>(draw.in_cube(1))};
    if (parallel) camera.projection = Orthographic{draw.number(1, 3)};
    const CameraFrame frame = camera_frame(camera, {2 * draw.integer(1, 20), 2 * draw.integer(1, 20)});
    const Ray ray{eye, parallel ? convert<float>(frame.forward) : direction};
    const Vec3f touched = eye + ray.direction * cast<float>(parallel ? 4 : draw.integer(2, 5));
    const Scene scene{.objects = {with_corner_at(touched, draw)}}, nothing;
    const auto list = make_accelerator("list", scene), behind = make_accelerator("list", nothing);
    Traversal traversal;
    const auto expected = list->closest(ray, traversal),
               given = ItemBuffer(scene, frame, *behind).closest(ray, traversal);
    if (same(expected, given)) return std::nullopt;
    return fmt::format("{} instead of {}: {}", words(given), words(expected), adversarial::words(ray));
}

}  // namespace

TEST_CASE("an item buffer misses no triangle and no rectangle that a ray through the corner of a pixel just touches") {
    CHECK(faults(100'000, compare_touched) == "");
}

TEST_CASE("an item buffer answers as the list does, whatever the camera") { CHECK(faults(3'000, compare_view) == ""); }

TEST_CASE("an item buffer asks the structure behind it about other rays only") {
    const Scene scene{.objects = {object(Sphere{{0, 0, 0}, 1})}}, nothing;
    const auto behind = make_accelerator("list", nothing);
    const CameraFrame frame = camera_frame(scene.camera, {9, 9});
    const ItemBuffer buffer(scene, frame, *behind);
    Traversal traversal;
    Ray ray = eye_ray(frame, 4.5, 4.5);
    CHECK(buffer.closest(ray, traversal)->t == 4);
    ray.origin.x = 0.1f;
    CHECK_FALSE(buffer.closest(ray, traversal));
}

TEST_CASE("any number of threads draws the same item buffer", "[threads]") {
    Draw draw(1);
    const Scene scene = scene_of(soup(draw, 2000, 2)), nothing;
    const auto behind = make_accelerator("list", nothing);
    const ImageSize size{61, 143};
    const CameraFrame frame = camera_frame({.position = {0, 0, 6}, .target = {0, 0, 0}}, size);
    const ItemBuffer by_one(scene, frame, *behind, {.threads = 1});
    for (const int threads : {2, 3, 50}) {
        const ItemBuffer by_many(scene, frame, *behind, {.threads = threads});
        CHECK(by_many.bytes() == by_one.bytes());
        int others = 0;
        for (int row = 0; row < size.height; ++row)
            for (int column = 0; column < size.width; ++column) {
                Traversal of_one, of_many;
                const Ray ray = eye_ray(frame, column + 0.3, row + 0.6);
                others += by_many.items(column, row) != by_one.items(column, row) ||
                          !same(by_many.closest(ray, of_many), by_one.closest(ray, of_one)) ||
                          of_many.primitive_tests != of_one.primitive_tests;
            }
        CHECK(others == 0);
    }
    CHECK(*by_one.items(30, 71) > 0);
}

TEST_CASE("an item buffer of too many items keeps none, by any number of threads", "[threads]") {
    const std::vector<Triangle> everywhere(600, {{-9, -9, 0}, {9, -9, 0}, {0, 18, 0}});
    const Scene scene = scene_of(everywhere);
    const auto behind = make_accelerator("list", scene);
    const CameraFrame frame = camera_frame({.position = {0, 0, 2}, .target = {0, 0, 0}}, {8, 8});
    for (const int threads : {1, 2}) {
        const ItemBuffer buffer(scene, frame, *behind, {.threads = threads});
        CHECK_FALSE(buffer.items(4, 4));
        Traversal traversal;
        CHECK(buffer.closest(eye_ray(frame, 4, 4), traversal)->primitive.part == 0);
    }
}

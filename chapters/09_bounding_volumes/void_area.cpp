#include "void_area.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bvh/ray_box.h"
#include "raylab/accelerator/bvh/ray_slabs.h"
#include "raylab/accelerator/bvh/ray_sphere_bound.h"
#include "raylab/base/tiles.h"
#include "raylab/geometry/bounds/bounding_sphere.h"
#include "raylab/geometry/intersect/nearest.h"
#include "raylab/sampling/sequence.h"
#include "raylab/tracer/picture/first_hit_picture.h"

#include <fmt/format.h>

namespace raylab::volumes {

namespace {

/// An object's three bounds.
struct Bounds {
    Sphere sphere;
    Box box;
    Slabs oriented_box;

    explicit Bounds(const Object& object) {
        const Hull balls = hull(object.shape, object.placement);
        sphere = bounding_sphere(balls);
        box = bounds(object.shape, object.placement).value();
        oriented_box = bounding_slabs(balls);
    }

    Sphere around_all() const {
        const Vec3d center = box.center(), half = center - convert<double>(box.min);
        const auto to = [&](const Vec3f& other) { return glm::length(convert<double>(other) - center); };
        const double radius = std::max({glm::length(half), to(sphere.center) + sphere.radius,
                                        to(oriented_box.center) + glm::length(convert<double>(oriented_box.half))});
        return {convert<float>(center), cast<float>(1.001 * radius)};
    }

    std::array<bool, 3> hit_found(const Ray& ray) const {
        constexpr double missed = std::numeric_limits<double>::infinity();
        BoxTree::Planes planes{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            planes[axis][0] = box.min[static_cast<int>(axis)];
            planes[axis + 3][0] = box.max[static_cast<int>(axis)];
        }
        return {SphereBoundRay(ray).entry(sphere) < missed, BoxRay(ray).entries(planes)[0] < missed,
                SlabsRay(ray).entry(oriented_box) < missed};
    }
};

bool rays_hitting(const Ray& ray, const Object& object) {
    DecisionCounts decisions;
    return intersect(ray, object.shape, object.placement, decisions, object.sides).has_value();
}

// A random line through a sphere: any direction, and any place on a disk perpendicular to it.
Ray any_line(RandomSequence& random, const Sphere& ball) {
    const Vec3d direction = random.unit_vector(), u = random.unit_vector_across(direction), v = cross(direction, u);
    double x = 1, y = 1;
    while (x * x + y * y > 1) {
        x = random.between(-1, 1);
        y = random.between(-1, 1);
    }
    const Vec3d origin = convert<double>(ball.center) + (u * x + v * y - direction * 2.0) * double{ball.radius};
    return {convert<float>(origin), convert<float>(direction)};
}

}  // namespace

SeenAreas seen_areas(const Object& object, std::size_t rays, std::uint64_t seed) {
    const Bounds bounds(object);
    const Sphere all = bounds.around_all();
    std::array<std::size_t, 4> hit_found{};
    for (std::size_t i = 0; i < rays; ++i) {
        RandomSequence random(seed, i);
        const Ray ray = any_line(random, all);
        const auto in = bounds.hit_found(ray);
        hit_found[0] += rays_hitting(ray, object);
        for (std::size_t which = 0; which < 3; ++which) hit_found[which + 1] += in[which];
    }
    const double screen = 3.14159265358979 * all.radius * all.radius;
    const auto area = [&](std::size_t which) {
        return screen * static_cast<double>(hit_found[which]) / static_cast<double>(rays);
    };
    return {area(0), area(1), area(2), area(3)};
}

std::vector<std::string> void_header() { return {"object", "sphere", "box", "oriented box"}; }

std::vector<std::vector<std::string>> void_rows(const Scene& scene, const ChapterRun& run) {
    std::vector<std::vector<std::string>> rows;
    const auto words = [](double share) { return fmt::format("{:.0f} %", 100 * share); };
    for (const Object& object : scene.objects) {
        const SeenAreas seen = seen_areas(object, run.sized<std::size_t>(100'000, 4'000), run.seed);
        rows.push_back({scene.materials[object.front].name, words(seen.empty(seen.sphere)), words(seen.empty(seen.box)),
                        words(seen.empty(seen.oriented_box))});
    }
    return rows;
}

Image void_picture(const Scene& scene, Volume volume, const ChapterRun& run) {
    const std::vector<Bounds> all(scene.objects.begin(), scene.objects.end());
    const ImageSize size = run.sized(scene.image, ImageSize{scene.image.width / 2, scene.image.height / 2});
    const int per_side = run.sized(3, 1);
    const CameraFrame frame = camera_frame(scene.camera, size, scene.source);
    const auto accelerator = make_accelerator("auto", scene);
    const auto seen = [&](double x, double y) {
        const Ray ray = eye_ray(frame, x, y);
        int in_vain = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            in_vain += all[i].hit_found(ray)[static_cast<std::size_t>(volume)] && !rays_hitting(ray, scene.objects[i]);
        const Color color = first_hit_color(scene, *accelerator, ray, FirstHitShading::light, shoulder_light(frame));
        const double red = 1 - std::pow(0.6, in_vain);
        return color * (1 - 0.75 * red) + Color{0.8, 0.13, 0.05} * (0.75 * red);
    };
    Image image(size.width, size.height);
    for_each_piece(static_cast<std::size_t>(size.height), 8, run.threads, [&](std::size_t begin, std::size_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
            for (int x = 0; x < size.width; ++x) {
                Color sum{0, 0, 0};
                for (int i = 0; i < per_side; ++i)
                    for (int j = 0; j < per_side; ++j) sum += seen(x + (i + 0.5) / per_side, y + (j + 0.5) / per_side);
                image.at(x, y) = to_pixel(sum / static_cast<double>(per_side * per_side));
            }
    });
    return image;
}

}  // namespace raylab::volumes

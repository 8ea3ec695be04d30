#include "pictures.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/ray_quadric/ray_quadric.h"
#include "raylab/geometry/intersect/intersect.h"
#include "raylab/geometry/surface/gradient.h"
#include "raylab/image/draw.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/picture/first_hit_picture.h"
#include "raylab/tracer/shading/surface_point.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <type_traits>

namespace raylab {

namespace {

/// A quadric of the scene with the colours of its two sides.
struct Colored {
    Quadric quadric;
    Color outside, inside;
};

/// The nearest hit among several quadrics.
struct Seen {
    const Colored* what;
    QuadricHit<double> hit;
};

std::optional<Seen> first_seen(const std::vector<Colored>& quadrics, const Ray& ray) {
    std::optional<Seen> nearest;
    for (const Colored& colored : quadrics) {
        const auto hit = nearest_quadric_hit(in<double>(ray), colored.quadric);
        if (hit && (!nearest || hit->t < nearest->hit.t)) nearest = Seen{&colored, *hit};
    }
    return nearest;
}

enum class Normals { raw, normalised };

Color lit(const Seen& seen, const Ray& ray, Normals normals, const Vec3d& to_light) {
    const Vec3d direction = convert<double>(ray.direction);
    const Vec3d point = convert<double>(ray.origin) + direction * seen.hit.t;
    const Quadric& quadric = seen.what->quadric;
    const Vec3d outward = normals == Normals::raw ? gradient<double>(quadric, point, seen.hit.part)
                                                  : gradient_normal<double>(quadric, point, seen.hit.part);
    const Color& color = dot(outward, direction) < 0 ? seen.what->outside : seen.what->inside;
    return color * (0.15 + 0.85 * std::max(0.0, dot(facing(outward, direction), glm::normalize(to_light))));
}

EyePictureOptions options_of(const ChapterRun& run) {
    return {.samples = {.per_side = run.sized(3, 1)}, .threads = run.threads};
}

// Of pictures that stand side by side.
CameraFrame still_life_frame(const Scene& scene, const ChapterRun& run) {
    const int part = run.sized(2, 4);
    return camera_frame(scene.camera, {scene.image.width / part, scene.image.height / part}, scene.source);
}

Image drawn(const std::vector<Colored>& quadrics, const CameraFrame& frame, Normals normals, const ChapterRun& run) {
    const Vec3d to_light = shoulder_light(frame);
    return eye_picture(frame, options_of(run), [&](const Ray& ray) {
        const auto seen = first_seen(quadrics, ray);
        return seen ? lit(*seen, ray, normals, to_light) : sky;
    });
}

Color plain(const Pigment& pigment) {
    const auto* color = std::get_if<Color>(&pigment);
    return color ? *color : std::get<Checker>(pigment).a;
}

// The objects of a scene that are quadrics; the others (the table) are left out.
std::vector<Colored> quadrics_of(const Scene& scene) {
    std::vector<Colored> found;
    for (const Object& object : scene.objects)
        std::visit(
            [&]<class S>(const S& shape) {
                if constexpr (std::is_constructible_v<Quadric, const S&>) {
                    assert(object.placement.is_identity());
                    found.push_back({shape, plain(scene.materials[object.front].diffuse),
                                     plain(scene.materials[object.back].diffuse)});
                }
            },
            object.shape);
    return found;
}

int objects_hit(const Scene& scene, const Ray& ray) {
    DecisionCounts decisions;
    return static_cast<int>(std::ranges::count_if(scene.objects, [&](const Object& object) {
        return intersect(ray, object.shape, object.placement, decisions).has_value();
    }));
}

}  // namespace

Image still_life(const Scene& scene, const ChapterRun& run) {
    const int part = run.sized(1, 4);
    const ImageSize size{scene.image.width / part, scene.image.height / part};
    return chapter_picture(scene, size, run);
}

std::vector<Step> still_life_steps(const Scene& scene, const ChapterRun& run) {
    const CameraFrame frame = still_life_frame(scene, run);
    const auto overlay = [&scene](const Ray& ray) { return Color(std::pow(0.55, objects_hit(scene, ray))); };
    const std::shared_ptr<const Accelerator> accelerator = make_accelerator("list", scene);
    const auto depth = [accelerator](const Ray& ray) {
        constexpr double front = 5.5, back = 10;  // metres from the eye
        Traversal traversal;
        const auto hit = accelerator->closest(ray, traversal);
        return hit ? Color(std::clamp((hit->t - front) / (back - front), 0.0, 0.9)) : Color(1);
    };
    return {{"still_life_hit", [=] { return eye_picture(frame, options_of(run), overlay); }},
            {"still_life_t", [=] { return eye_picture(frame, options_of(run), depth); }},
            {"still_life_normals",
             [=, &scene] {
                 return first_hit_picture(scene, *accelerator, frame, FirstHitShading::normals, options_of(run));
             },
             Page::Keep::floats}};
}

std::vector<Step> quadric_steps(const ChapterRun& run) {
    const Vec3f base{0, -1, 0}, top{0, 1, 0};
    const int side = run.sized(250, 75);
    const CameraFrame frame = camera_frame({.position = {1.6, 3.2, 5.2}, .projection = Perspective{27}}, {side, side});
    const auto row = [=](const std::vector<std::pair<std::string, Quadric>>& named) {
        std::vector<Image> images;
        for (const auto& [name, quadric] : named) {
            const Colored colored{quadric, {0.0, 0.22, 0.45}, {0.79, 0.5, 0.1}};
            images.push_back(
                with_caption(drawn({colored}, frame, Normals::normalised, run), name, run.sized(17.0, 7.0)));
        }
        return side_by_side(images);
    };
    const auto revolutions = [=](Ends ends) -> std::vector<std::pair<std::string, Quadric>> {
        return {{"cylinder", Cylinder{base, top, 0.7f, ends}},
                {"cone", Cone{base, top, 0.9f, 0, ends}},
                {"cone, cut", Cone{base, top, 0.8f, 0.45f, ends}},
                {"paraboloid", Paraboloid{base, top, 0.9f, ends}},
                {"hyperboloid", Hyperboloid{base, top, 0.35f, 0.8f, ends}}};
    };
    return {{"quadrics_open", [=] { return row(revolutions(Ends::open)); }},
            {"quadrics_capped", [=] { return row(revolutions(Ends::capped)); }}};
}

std::vector<Step> gradient_steps(const Scene& scene, const ChapterRun& run) {
    const auto by = [=, &scene](Normals normals) {
        return drawn(quadrics_of(scene), still_life_frame(scene, run), normals, run);
    };
    return {{"gradient_raw", [=] { return by(Normals::raw); }},
            {"gradient_unit", [=] { return by(Normals::normalised); }}};
}

}  // namespace raylab

#include "raylab/tracer/media/eye_media.h"

#include "raylab/scene/moving.h"
#include "raylab/tracer/shading/ray_start.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace raylab {

namespace {

bool is_medium(const Scene& scene, const Object& object) {
    return scene.materials[object.front].kt > 0 && is_closed(object.shape);
}

bool is_in_a_medium(const Scene& scene, const Region& region) {
    return std::ranges::any_of(scene.objects, [&](const Object& object) {
        return is_medium(scene, object) && containment_always(scene, object, region) != Containment::outside;
    });
}

// All points from which a camera's rays start.
Region starts(const Camera& camera, const CameraFrame& frame) {
    if (frame.projection == CameraFrame::Projection::perspective && !camera.lens)
        return region_about(convert<double>(convert<float>(frame.eye)));
    const double lens = camera.lens ? camera.lens->radius : 0;
    const bool parallel = frame.projection == CameraFrame::Projection::orthographic;
    const Vec3d reach = (lens + (parallel ? frame.half_width : 0)) * glm::abs(frame.right) +
                        (lens + (parallel ? frame.half_height : 0)) * glm::abs(frame.up);
    return region_about(frame.eye,
                        reach * (1 + 1e-5) + glm::abs(frame.eye) * 1e-6);  // origins are rounded to floats: by 6e-8
}

}  // namespace

Media media_at(const Scene& scene, const Accelerator& accelerator, const Vec3f& point, float time) {
    if (!is_in_a_medium(scene, region_about(convert<double>(point)))) return {};
    // Along any way out: what is left without having been entered lies around the point, the innermost first.
    const Vec3f direction{0.48f, 0.6f, 0.64f};
    std::vector<const Object*> entered, around;
    Ray ray{.origin = point, .direction = direction, .time = time};
    Traversal traversal;
    while (const auto hit = accelerator.closest(ray, traversal)) {
        const SurfacePoint at = surface_point(scene, ray, *hit);
        if (is_medium(scene, *at.object)) {
            const auto found = std::ranges::find(entered, at.object);
            if (dot(at.normal, convert<double>(direction)) <= 0)
                entered.push_back(at.object);
            else if (found != entered.end())
                entered.erase(found);
            else
                around.push_back(at.object);
        }
        ray = ray_from(at, convert<double>(direction), std::numeric_limits<double>::infinity(), {}, ray, hit->t);
        ray.time = time;
    }
    Media media;
    for (auto object = around.rbegin(); object != around.rend(); ++object) media = media.entered(*object);
    return media;
}

EyeMedia::EyeMedia(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame)
    : scene_(scene), accelerator_(accelerator) {
    if (!is_in_a_medium(scene, starts(scene.camera, frame)))
        of_all_ = Media{};
    else if (frame.projection == CameraFrame::Projection::perspective && !scene.camera.lens && !anything_moves(scene))
        of_all_ = media_at(scene, accelerator, convert<float>(frame.eye));
}

}  // namespace raylab

#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/media/media.h"

#include <optional>

namespace raylab {

/// The media around a point at a time: every closed transparent object it lies in, the outermost entered first. Of a
/// mesh nobody asks whether it is closed; a ray that leaves one unentered has been inside of it, all the same.
Media media_at(const Scene& scene, const Accelerator& accelerator, const Vec3f& point, float time = 0);

/// Eye rays where nothing is transparent.
class EmptySpace {
public:
    EmptySpace(const Scene&, const Accelerator&, const CameraFrame&) {}

    template <class Work>
    auto around(const Ray&, const Work& work) const {
        return work(Media{});
    }
};

/// The media in which a camera's eye rays begin, found once for a pinhole if none moves about it.
class EyeMedia {
public:
    EyeMedia(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame);

    /// Calls `work` with the media in which the ray begins.
    template <class Work>
    auto around(const Ray& eye_ray, const Work& work) const {
        return of_all_ ? work(*of_all_) : work(media_at(scene_, accelerator_, eye_ray.origin, eye_ray.time));
    }

private:
    const Scene& scene_;
    const Accelerator& accelerator_;
    std::optional<Media> of_all_;  // absent: they differ
};

}  // namespace raylab

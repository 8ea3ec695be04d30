#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/media.h"

#include <optional>

namespace raylab {

/// The media around a point: every closed transparent object it lies in, the outermost entered first. Of a mesh nobody
/// asks whether it is closed; a ray that leaves one unentered has been inside of it, all the same.
Media media_at(const Scene& scene, const Accelerator& accelerator, const Vec3f& point);

/// The media in which a camera's eye rays begin, found once for a pinhole.
class EyeMedia {
public:
    EyeMedia(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame);

    Media of(const Ray& eye_ray) const;

private:
    const Scene& scene_;
    const Accelerator& accelerator_;
    std::optional<Media> of_all_;  // absent: they differ
};

}  // namespace raylab

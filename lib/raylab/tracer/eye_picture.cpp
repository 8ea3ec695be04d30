#include "raylab/tracer/eye_picture.h"

namespace raylab {

Image eye_picture(const CameraFrame& frame, const EyePictureOptions& options,
                  const std::function<Color(const Ray&)>& color) {
    return eye_picture_by_tiles(frame, options, [&] { return [&](const Ray& ray) { return color(ray); }; });
}

}  // namespace raylab

#include "raylab/tracer/picture/eye_picture.h"

namespace raylab {

Image eye_picture(const CameraFrame& frame, const EyePictureOptions& options,
                  const std::function<Color(const Ray&)>& color) {
    return eye_picture_by_tiles(frame, options, [&](const auto& draw) { draw(color); });
}

}  // namespace raylab

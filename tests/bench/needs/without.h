#pragma once

#include "raylab/image/image.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/whitted/whitted.h"
#include "raylab/transport/path/transport_options.h"

#include <string>
#include <vector>

/// A scene that does not need one feature of the renderer.
struct NeedlessPicture {
    std::string feature;
    raylab::Scene scene;
    raylab::WhittedOptions options;

    raylab::CameraFrame frame() const { return camera_frame(scene.camera, scene.image); }
};

/// One for each feature that is measured.
std::vector<NeedlessPicture> needless_pictures();

/// The picture as `raylab render` draws it on one thread, including the construction of the accelerator.
raylab::Image drawn_by_renderer(const NeedlessPicture& picture);

/// The same bits by the same renderer, compiled without the feature.
raylab::Image drawn_without(const NeedlessPicture& picture);

/// The same of rays that spread: a scene without a lens, without motion, gloss and area lights.
struct NeedlessSpread {
    std::string feature;
    raylab::Scene scene;
    raylab::TransportOptions options;
};
std::vector<NeedlessSpread> needless_spreads();
raylab::Image drawn_by_renderer(const NeedlessSpread& picture);
raylab::Image drawn_without(const NeedlessSpread& picture);

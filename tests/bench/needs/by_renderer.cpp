#include "pictures.h"

#include "raylab/tracer/only_needed.h"
#include "raylab/tracer/whitted_picture.h"

raylab::Image by_renderer(const raylab::Scene& scene, const raylab::CameraFrame& frame) {
    const auto options = only_needed(scene, raylab::WhittedOptions{});
    const auto accelerator = raylab::make_accelerator("auto", scene);
    return whitted_picture(scene, *accelerator, frame, options, {.threads = 1});
}

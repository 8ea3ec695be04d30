#include "raylab/tracer/picture/whitted_picture.h"

#include "raylab/tracer/whitted/whitted_stage.h"

#include <chrono>
#include <mutex>

namespace raylab {

namespace {

// Calls draw(stage) with the stage of this renderer's model.
template <class DrawTile>
auto on_stage(Renderer renderer, const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
              const WhittedOptions& options, const DrawTile& draw) {
    switch (renderer) {
        case Renderer::local_light:
            return draw(WhittedStage<LocalLightModel>(scene, accelerator, frame, options));
        case Renderer::direct_light:
            return draw(WhittedStage<DirectLightModel>(scene, accelerator, frame, options));
        case Renderer::whitted:
            break;
    }
    return draw(WhittedStage<WhittedModel>(scene, accelerator, frame, options));
}

}  // namespace

Renderer cheapest_renderer(const Scene& scene, const WhittedOptions& options) {
    return cheapest_renderer(scene,
                             {.shadow_rays = options.shadows == WhittedOptions::Shadows::cast, .depth = options.depth});
}

Image whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                      const WhittedOptions& options, const EyePictureOptions& picture) {
    const Renderer renderer = cheapest_renderer(scene, options);
    return on_stage(renderer, scene, accelerator, frame, options, [&](const auto& stage) {
        return eye_picture_by_tiles(frame, picture, [&](const auto& draw) { stage.trace_tile(NoObserver{}, draw); });
    });
}

WhittedPicture counted_whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                                       const WhittedOptions& options, const EyePictureOptions& picture) {
    const Renderer renderer = cheapest_renderer(scene, options);
    return on_stage(renderer, scene, accelerator, frame, options, [&](const auto& stage) {
        WhittedPicture result;
        std::mutex mutex;
        const auto begun = std::chrono::steady_clock::now();
        result.image = eye_picture_by_tiles(frame, picture, [&](const auto& draw) {
            RayCounts rays;
            const TestCounts tests = stage.trace_tile(CountingObserver{rays}, draw);
            const std::scoped_lock lock(mutex);
            result.rays.add(rays);
            result.traversal.add(tests);
        });
        result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        return result;
    });
}

RayTree sample_tree(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                    const WhittedOptions& options, const PixelSamples& samples, const PixelSample& sample) {
    const Renderer renderer = cheapest_renderer(scene, options);
    return on_stage(renderer, scene, accelerator, frame, options, [&](const auto& stage) {
        RayTree tree;
        stage.trace_tile(RecordingObserver{tree}, [&](auto&& color) {
            tree.pixel = color(sample_ray(frame, sample.x, sample.y, samples, sample.number));
        });
        return tree;
    });
}

}  // namespace raylab

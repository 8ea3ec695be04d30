#include "raylab/tracer/whitted_picture.h"

#include "raylab/accelerator/list.h"
#include "raylab/tracer/eye_media.h"
#include "raylab/tracer/listed_spheres.h"
#include "raylab/tracer/lone_sphere.h"
#include "raylab/tracer/plain_tracer.h"
#include "raylab/tracer/whitted_tracer.h"

#include <chrono>
#include <mutex>
#include <type_traits>

namespace raylab {

namespace {

// What all tiles of a picture share. Calls draw(color) with a tile's tracer of eye rays, made for it: what it keeps counts
// in must not be seen by others.
template <class Model>
class Stage {
public:
    Stage(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame, const WhittedOptions& options)
        : scene_(scene), surfaces_(scene, accelerator), lighting_(scene), eye_media_(scene, accelerator, frame), options_(options) {}

    template <class Observer>
    Traversal trace_tile(Observer observer, const auto& draw) const {
        Traversal traversal;
        WhittedTracer<Observer, Model> trace(scene_, surfaces_, lighting_, options_, traversal, observer);
        draw([&](const Ray& ray) { return eye_media_.around(ray, [&](const Media& media) { return trace(ray, media); }); });
        return traversal;
    }

private:
    const Scene& scene_;
    const typename Model::Surfaces surfaces_;
    const Lighting lighting_;
    const std::conditional_t<Model::recursion, EyeMedia, EmptySpace> eye_media_;
    const WhittedOptions& options_;
};

template <class Spheres>
class PlainStage {
public:
    PlainStage(const Scene& scene, const Accelerator& list) : scene_(scene), lighting_(scene), spheres_(scene, list, lighting_) {}

    template <class Observer>
    TestCounts trace_tile(Observer observer, const auto& draw) const {
        PlainTracer<Observer, Spheres> trace(scene_, spheres_, lighting_, observer);
        draw(trace);
        return trace.tests();
    }

private:
    const Scene& scene_;
    const Lighting lighting_;
    const Spheres spheres_;
};

// Calls draw(stage) with the stage of this renderer's model.
template <class Draw>
auto on_stage(Renderer renderer, const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
              const WhittedOptions& options, const Draw& draw) {
    switch (renderer) {
        case Renderer::plain_spheres:
            if (LoneSphere::suits(scene)) return draw(PlainStage<LoneSphere>(scene, accelerator));
            return draw(PlainStage<ListedSpheres>(scene, accelerator));
        case Renderer::local_light: return draw(Stage<LocalLightModel>(scene, accelerator, frame, options));
        case Renderer::whitted: break;
    }
    return draw(Stage<WhittedModel>(scene, accelerator, frame, options));
}

}  // namespace

PictureAsks picture_asks(const WhittedOptions& options) {
    return {.feelers = options.shadows == WhittedOptions::Shadows::cast,
            .depth = options.depth,
            .usual_look = options.viewer == WhittedOptions::Viewer::local && options.lit == WhittedOptions::Lit::viewers_side};
}

Renderer least_renderer(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options) {
    return least_renderer(scene, picture_asks(options), dynamic_cast<const List*>(&accelerator) ? FoundBy::list : FoundBy::other);
}

Image whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                      const WhittedOptions& options, const EyePictureOptions& picture) {
    const Renderer renderer = least_renderer(scene, accelerator, options);
    return on_stage(renderer, scene, accelerator, frame, options, [&](const auto& stage) {
        return eye_picture_by_tiles(frame, picture, [&](const auto& draw) { stage.trace_tile(NoObserver{}, draw); });
    });
}

WhittedPicture counted_whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                                       const WhittedOptions& options, const EyePictureOptions& picture) {
    const Renderer renderer = least_renderer(scene, accelerator, options);
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

}  // namespace raylab

#include "raylab/tracer/whitted_picture.h"

#include "raylab/accelerator/list.h"
#include "raylab/tracer/eye_media.h"
#include "raylab/tracer/whitted_tracer.h"

#include <chrono>
#include <mutex>
#include <type_traits>

namespace raylab {

namespace {

// What all tiles of a picture share.
template <class Model>
struct Stage {
    Stage(const Scene& of, const Accelerator& accelerator, const CameraFrame& frame, const WhittedOptions& asked)
        : scene(of), surfaces(of, accelerator), lighting(of), eye_media(of, accelerator, frame), options(asked) {}

    const Scene& scene;
    const typename Model::Surfaces surfaces;
    const Lighting lighting;
    const std::conditional_t<Model::recursion, EyeMedia, EmptySpace> eye_media;
    const WhittedOptions& options;
};

// A tile's colours, where nothing is counted.
template <class Model>
class PlainColor {
public:
    explicit PlainColor(const Stage<Model>& stage)
        : eye_media_(stage.eye_media),
          trace_(stage.scene, stage.surfaces, stage.lighting, stage.options, traversal_, {}) {}
    PlainColor(const PlainColor&) = delete;
    PlainColor& operator=(const PlainColor&) = delete;

    Color operator()(const Ray& ray) {
        return eye_media_.around(ray, [&](const Media& media) { return trace_(ray, media); });
    }

private:
    decltype(Stage<Model>::eye_media)& eye_media_;
    Traversal traversal_;
    WhittedTracer<NoObserver, Model> trace_;
};

// A tile's colours, and how many rays and tests they took: added to the picture's when the tile is done.
template <class Model>
class CountedColor {
public:
    CountedColor(const Stage<Model>& stage, WhittedPicture& picture, std::mutex& mutex)
        : eye_media_(stage.eye_media),
          trace_(stage.scene, stage.surfaces, stage.lighting, stage.options, traversal_, {rays_}),
          picture_(picture),
          mutex_(mutex) {}
    CountedColor(const CountedColor&) = delete;
    CountedColor& operator=(const CountedColor&) = delete;
    ~CountedColor() {
        const std::scoped_lock lock(mutex_);
        picture_.rays.add(rays_);
        picture_.traversal.add(traversal_);
    }

    Color operator()(const Ray& ray) {
        return eye_media_.around(ray, [&](const Media& media) { return trace_(ray, media); });
    }

private:
    decltype(Stage<Model>::eye_media)& eye_media_;
    RayCounts rays_;
    Traversal traversal_;
    WhittedTracer<CountingObserver, Model> trace_;
    WhittedPicture& picture_;
    std::mutex& mutex_;
};

// Calls draw(stage) with the stage of this renderer's model.
template <class Draw>
auto on_stage(Renderer renderer, const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
              const WhittedOptions& options, const Draw& draw) {
    switch (renderer) {
        case Renderer::plain_spheres: return draw(Stage<PlainSpheres>(scene, accelerator, frame, options));
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
    return on_stage(renderer, scene, accelerator, frame, options, [&]<class Model>(const Stage<Model>& stage) {
        return eye_picture_by_tiles(frame, picture, [&] { return PlainColor<Model>(stage); });
    });
}

WhittedPicture counted_whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                                       const WhittedOptions& options, const EyePictureOptions& picture) {
    const Renderer renderer = least_renderer(scene, accelerator, options);
    return on_stage(renderer, scene, accelerator, frame, options, [&]<class Model>(const Stage<Model>& stage) {
        WhittedPicture result;
        std::mutex mutex;
        const auto begun = std::chrono::steady_clock::now();
        result.image = eye_picture_by_tiles(frame, picture, [&] { return CountedColor<Model>(stage, result, mutex); });
        result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        return result;
    });
}

}  // namespace raylab

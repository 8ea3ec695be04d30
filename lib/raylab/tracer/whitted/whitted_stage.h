#pragma once

#include "raylab/tracer/media/eye_media.h"
#include "raylab/tracer/whitted/whitted_tracer.h"

#include <type_traits>

namespace raylab {

/// The scene, made ready for one picture: all its tiles share it.
template <class Model>
class WhittedStage {
public:
    WhittedStage(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                 const WhittedOptions& options)
        : scene_(scene),
          surfaces_(scene, accelerator),
          lighting_(scene),
          eye_media_(scene, accelerator, frame),
          options_(options) {}

    /// Calls draw(color) with a tracer of eye rays that is made for one tile: its counts are its own.
    template <class Observer>
    Traversal trace_tile(Observer observer, const auto& draw) const {
        Traversal traversal;
        WhittedTracer<Observer, Model> trace(scene_, surfaces_, lighting_, options_, traversal, observer);
        draw([&](const Ray& ray) {
            return eye_media_.around(ray, [&](const Media& media) { return trace(ray, media); });
        });
        return traversal;
    }

private:
    const Scene& scene_;
    const typename Model::Surfaces surfaces_;
    const Lighting lighting_;
    const std::conditional_t<Model::media, EyeMedia, EmptySpace> eye_media_;
    const WhittedOptions& options_;
};

}  // namespace raylab

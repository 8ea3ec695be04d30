#include "raylab/tracer/whitted/whitted.h"

#include "raylab/tracer/media/eye_media.h"
#include "raylab/tracer/whitted/whitted_tracer.h"

namespace raylab {

namespace {

template <class Observer>
Color trace(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options, const Ray& ray,
            const Media& around_eye, Traversal& traversal, Observer observer) {
    const OneRay::Surfaces surfaces(scene, accelerator);
    const Lighting lighting(scene);
    return WhittedTracer<Observer, OneRay>(scene, surfaces, lighting, options, traversal, observer)(ray, around_eye);
}

}  // namespace

Color whitted_color(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options, const Ray& ray,
                    Traversal& traversal, const Media& around_eye) {
    return trace(scene, accelerator, options, ray, around_eye, traversal, NoObserver{});
}

Color whitted_color(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options, const Ray& ray,
                    Traversal& traversal, RayCounts& counts, const Media& around_eye) {
    return trace(scene, accelerator, options, ray, around_eye, traversal, CountingObserver{counts});
}

RayTree ray_tree(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options, const Ray& ray) {
    RayTree tree;
    Traversal traversal;
    const Media around_eye = media_at(scene, accelerator, ray.origin);
    tree.pixel = trace(scene, accelerator, options, ray, around_eye, traversal, RecordingObserver{tree});
    return tree;
}

}  // namespace raylab

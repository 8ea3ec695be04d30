#include "raylab/tracer/whitted_picture.h"

#include "raylab/tracer/eye_media.h"
#include "raylab/tracer/whitted_tracer.h"

#include <algorithm>
#include <chrono>
#include <mutex>

namespace raylab {

namespace {

// What a picture is made of.
struct Task {
    const Scene& scene;
    const Accelerator& accelerator;
    const CameraFrame& frame;
    const WhittedOptions& options;
    const EyePictureOptions& picture;
};

// A tile's colours, where nothing is counted.
template <class Abilities>
class PlainColor {
public:
    PlainColor(const Task& task, const EyeMedia& eye_media)
        : trace_(task.scene, task.accelerator, task.options, traversal_, {}), eye_media_(eye_media) {}
    PlainColor(const PlainColor&) = delete;
    PlainColor& operator=(const PlainColor&) = delete;

    Color operator()(const Ray& ray) {
        return eye_media_.around(ray, [&](const Media& media) { return trace_(ray, media); });
    }

private:
    Traversal traversal_;
    WhittedTracer<NoObserver, Abilities> trace_;
    const EyeMedia& eye_media_;
};

template <class Abilities>
Image plain_picture(const Task& task) {
    const EyeMedia eye_media(task.scene, task.accelerator, task.frame);
    return eye_picture_by_tiles(task.frame, task.picture, [&] { return PlainColor<Abilities>(task, eye_media); });
}

// A tile's colours, and how many rays and tests they took: added to the picture's when the tile is done.
template <class Abilities>
class CountedColor {
public:
    CountedColor(const Task& task, const EyeMedia& eye_media, WhittedPicture& picture, std::mutex& mutex)
        : trace_(task.scene, task.accelerator, task.options, traversal_, {rays_}),
          eye_media_(eye_media),
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
    RayCounts rays_;
    Traversal traversal_;
    WhittedTracer<CountingObserver, Abilities> trace_;
    const EyeMedia& eye_media_;
    WhittedPicture& picture_;
    std::mutex& mutex_;
};

template <class Abilities>
WhittedPicture counted_picture(const Task& task) {
    WhittedPicture result{.image = Image(task.frame.image.width, task.frame.image.height)};
    const EyeMedia eye_media(task.scene, task.accelerator, task.frame);
    std::mutex mutex;
    const auto begun = std::chrono::steady_clock::now();
    result.image = eye_picture_by_tiles(task.frame, task.picture,
                                        [&] { return CountedColor<Abilities>(task, eye_media, result, mutex); });
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return result;
}

}  // namespace

bool needs_local_light_only(const Scene& scene, const WhittedOptions& options) {
    if (options.shadows == WhittedOptions::Shadows::cast) return false;
    return std::ranges::all_of(scene.materials, [&](const Material& material) {
        return material.kt == 0 && (material.kr == 0 || options.depth == 1);
    });
}

Image whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                      const WhittedOptions& options, const EyePictureOptions& picture) {
    const Task task{scene, accelerator, frame, options, picture};
    return needs_local_light_only(scene, options) ? plain_picture<LocalLightOnly>(task) : plain_picture<AllAbilities>(task);
}

WhittedPicture counted_whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                                       const WhittedOptions& options, const EyePictureOptions& picture) {
    const Task task{scene, accelerator, frame, options, picture};
    return needs_local_light_only(scene, options) ? counted_picture<LocalLightOnly>(task) : counted_picture<AllAbilities>(task);
}

}  // namespace raylab

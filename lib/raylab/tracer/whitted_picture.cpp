#include "raylab/tracer/whitted_picture.h"

#include "raylab/tracer/eye_media.h"

#include <chrono>
#include <mutex>

namespace raylab {

namespace {

// A tile's counts, added to the picture's when the tile is done.
class TileColor {
public:
    TileColor(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options, const EyeMedia& eye_media,
              WhittedPicture& picture, std::mutex& mutex)
        : scene_(scene), accelerator_(accelerator), options_(options), eye_media_(eye_media), picture_(picture), mutex_(mutex) {}
    TileColor(const TileColor&) = delete;
    TileColor& operator=(const TileColor&) = delete;
    ~TileColor() {
        const std::scoped_lock lock(mutex_);
        picture_.rays.add(rays_);
        picture_.traversal.add(traversal_);
    }

    Color operator()(const Ray& ray) {
        return eye_media_.around(ray, [&](const Media& media) {
            return whitted_color(scene_, accelerator_, options_, ray, traversal_, rays_, media);
        });
    }

private:
    const Scene& scene_;
    const Accelerator& accelerator_;
    const WhittedOptions& options_;
    const EyeMedia& eye_media_;
    WhittedPicture& picture_;
    std::mutex& mutex_;
    RayCounts rays_;
    Traversal traversal_;
};

}  // namespace

Image whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                      const WhittedOptions& options, const EyePictureOptions& picture) {
    const EyeMedia eye_media(scene, accelerator, frame);
    return eye_picture_by_tiles(frame, picture, [&] {
        return [&, traversal = Traversal{}](const Ray& ray) mutable {
            return eye_media.around(ray, [&](const Media& media) {
                return whitted_color(scene, accelerator, options, ray, traversal, media);
            });
        };
    });
}

WhittedPicture counted_whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                                       const WhittedOptions& options, const EyePictureOptions& picture) {
    WhittedPicture result{.image = Image(frame.image.width, frame.image.height)};
    std::mutex mutex;
    const EyeMedia eye_media(scene, accelerator, frame);
    const auto begun = std::chrono::steady_clock::now();
    result.image = eye_picture_by_tiles(
        frame, picture, [&] { return TileColor(scene, accelerator, options, eye_media, result, mutex); });
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return result;
}

}  // namespace raylab

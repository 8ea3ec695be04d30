#pragma once

#include "raylab/base/tiles.h"
#include "raylab/image/sampled_image.h"
#include "raylab/tracer/media/eye_media.h"
#include "raylab/transport/path/eye_sample.h"
#include "raylab/transport/path/path_tracer.h"
#include "raylab/transport/path/transport_picture.h"

#include <chrono>
#include <functional>
#include <mutex>

namespace raylab {

/// The samples that a pixel gets.
struct SamplesOfPixel {
    SampleRange range;
    int of;  // the sampler's count
};
using SamplesOf =
    std::function<SamplesOfPixel(int x, int y)>;  // no template: one caller of the tracer, into which it is inlined

/// The scene, made ready for one picture: all its tiles share it.
template <class Model>
struct TransportStage {
    const Scene& scene;
    const Camera camera;  // the scene's, without a shutter that makes no difference
    const CameraFrame& frame;
    const TransportOptions options;
    const PixelFilter filter;
    const PathStage<Model> paths;
    const EyeMedia eye_media;

    TransportStage(const Scene& its_scene, const Accelerator& accelerator, const CameraFrame& its_frame,
                   const TransportOptions& its_options, PixelFilter its_filter)
        : scene(its_scene),
          camera(needed_camera(its_scene)),
          frame(its_frame),
          options(its_options),
          filter(its_filter),
          paths(scene, accelerator),
          eye_media(scene, accelerator, frame) {}

    SamplePlace place(int x, int y, int index) const {
        const auto width = static_cast<std::uint64_t>(frame.image.width);
        return {static_cast<std::uint64_t>(y) * width + static_cast<std::uint64_t>(x), x, y, index};
    }

    /// The sampler, told what the picture's points are spread together with.
    Sampler for_scene(Sampler sampler) const {
        sampler.beside_first = purpose::beside_picture(scene.camera, paths.area_lights);
        return sampler;
    }

    /// What a sample adds to its pixel.
    Color color(auto& trace, const Sampler& sampler, const SamplePlace& at) const {
        const EyeSample eye = eye_sample<Model>(frame, camera, filter, sampler, at);
        return eye.weight * eye_media.around(eye.ray, [&](const Media& media) { return trace(eye.ray, media, at); });
    }

    /// Adds to each pixel the samples that samples_of(x, y) tells. The same bits for any number of
    /// threads.
    TransportCounts add(SampledImage& image, Sampler shared_sampler, const SamplesOf& samples_of, Summand summand,
                        int threads, const std::string& label) const;
};

template <class Model>
TransportCounts TransportStage<Model>::add(SampledImage& image, Sampler shared_sampler, const SamplesOf& samples_of,
                                           Summand summand, int threads, const std::string& label) const {
    TransportCounts all;
    std::mutex mutex;
    const auto begun = std::chrono::steady_clock::now();
    for_each_tile(image.width(), image.height(), threads, label, [&](const Tile& tile) {
        RayCounts rays;
        Traversal traversal;
        Sampler sampler = for_scene(shared_sampler);
        PathTracer trace(paths, options, sampler, traversal, CountingObserver{rays});
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                PixelSums sums;
                const auto [range, of] = samples_of(x, y);
                sampler.count = of;
                for (int i = range.first; i < range.last; ++i) sums.add(color(trace, sampler, place(x, y, i)));
                PixelSums& pixel = image.at(x, y);
                if (summand == Summand::randomisation) {
                    pixel.add(sums.color / static_cast<double>(sums.count));
                } else {
                    pixel.color += sums.color;
                    pixel.squared_luminance += sums.squared_luminance;
                    pixel.count += sums.count;
                }
                for (int c = 0; c < 3; ++c) pixel.color[c] = in_two_floats(pixel.color[c]);
                pixel.squared_luminance = in_two_floats(pixel.squared_luminance);
            }
        const std::scoped_lock lock(mutex);
        all.rays.add(rays);
        all.traversal.add(traversal);
    });
    all.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return all;
}

}  // namespace raylab

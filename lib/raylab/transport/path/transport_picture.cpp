#include "raylab/transport/path/transport_picture.h"

#include "raylab/base/tiles.h"
#include "raylab/sampling/random.h"
#include "raylab/tracer/media/eye_media.h"
#include "raylab/transport/path/adaptive_counts.h"
#include "raylab/transport/path/eye_sample.h"
#include "raylab/transport/path/path_tracer.h"

#include <algorithm>
#include <chrono>
#include <mutex>

namespace raylab {

void TransportCounts::add(const TransportCounts& other) {
    rays.add(other.rays);
    traversal.add(other.traversal);
    seconds += other.seconds;
}

struct TransportPicture::Stage {
    const Scene& scene;
    const CameraFrame& frame;
    const TransportOptions options;
    const PixelFilter filter;
    const PathStage<PreparedSurfaces> paths;
    const EyeMedia eye_media;

    SamplePlace place(int x, int y, int index) const {
        const auto width = static_cast<std::uint64_t>(frame.image.width);
        return {static_cast<std::uint64_t>(y) * width + static_cast<std::uint64_t>(x), x, y, index};
    }

    // What a sample adds to its pixel.
    Color color(auto& trace, const Sampler& sampler, const SamplePlace& at) const {
        const EyeSample eye = eye_sample(frame, scene.camera, filter, sampler, at);
        return eye.weight * eye_media.around(eye.ray, [&](const Media& media) { return trace(eye.ray, media, at); });
    }
};

TransportPicture::TransportPicture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                                   const TransportOptions& options, PixelFilter filter)
    : stage_(new Stage{scene, frame, options, filter, PathStage<PreparedSurfaces>(scene, accelerator),
                       EyeMedia(scene, accelerator, frame)}) {}

TransportPicture::~TransportPicture() = default;

// `samples_of` tells for each pixel which samples it gets: a PixelSamples.
template <class SamplesOf>
TransportCounts TransportPicture::add_ranges(SampledImage& image, Sampler shared_sampler, const SamplesOf& samples_of,
                                             Summand summand, int threads, const std::string& label) const {
    TransportCounts all;
    std::mutex mutex;
    const auto begun = std::chrono::steady_clock::now();
    for_each_tile(image.width(), image.height(), threads, label, [&](const Tile& tile) {
        RayCounts rays;
        Traversal traversal;
        Sampler sampler = shared_sampler;
        PathTracer trace(stage_->paths, stage_->options, sampler, traversal, CountingObserver{rays});
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                PixelSums sums;
                const auto [range, of] = samples_of(x, y);
                sampler.count = of;
                for (int i = range.first; i < range.last; ++i)
                    sums.add(stage_->color(trace, sampler, stage_->place(x, y, i)));
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

TransportCounts TransportPicture::add(SampledImage& image, const Sampler& sampler, const SampleRange& range,
                                      Summand summand, int threads, const std::string& label) const {
    return add_ranges(
        image, sampler,
        [&](int, int) {
            return PixelSamples{range, sampler.count};
        },
        summand, threads, label);
}

TransportCounts TransportPicture::add(SampledImage& image, const Sampler& sampler, const std::vector<int>& counts,
                                      int threads, const std::string& label) const {
    const auto width = static_cast<std::size_t>(image.width());
    const auto all_of_pixel = [&](int x, int y) {
        const int count = counts[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
        return PixelSamples{{0, count}, count};
    };
    return add_ranges(image, sampler, all_of_pixel, Summand::sample, threads, label);
}

TransportCounts TransportPicture::add_adaptively(SampledImage& image, const Sampler& sampler, int threads,
                                                 const std::string& label) const {
    const int first = std::max(4, sampler.count / 8);
    const std::uint64_t other_seed = random_bits({.seed = sampler.seed, .dimension = 1});
    SampledImage tried(image.width(), image.height());
    TransportCounts counts = add(tried, {sampler.kind, first, other_seed}, {0, first}, Summand::sample, threads, label);
    counts.add(add(image, sampler, adaptive_counts(tried, sampler.count - first), threads, label));
    return counts;
}

RayTree TransportPicture::tree(const Sampler& sampler, int x, int y, int index) const {
    RayTree tree;
    Traversal traversal;
    PathTracer trace(stage_->paths, stage_->options, sampler, traversal, RecordingObserver{tree});
    tree.pixel = stage_->color(trace, sampler, stage_->place(x, y, index));
    return tree;
}

const std::vector<std::string>& TransportPicture::unsampled() const { return stage_->paths.area_lights.unsampled(); }

}  // namespace raylab

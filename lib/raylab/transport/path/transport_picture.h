#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/sampled_image.h"
#include "raylab/sampling/pixel_filter.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/whitted/whitted.h"
#include "raylab/transport/path/transport_options.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace raylab {

/// Samples of every pixel: those numbered first to last - 1 of the sampler's.
struct SampleRange {
    int first, last;
};

/// A share of a picture's samples: part 2 of 4.
struct SampleShare {
    int number = 1, of = 1;

    /// Those of so many samples.
    SampleRange range(int samples) const {
        const auto end = [&](int part) { return static_cast<int>(std::int64_t{samples} * part / of); };
        return {end(number - 1), end(number)};
    }
};

/// What a number of samples took.
struct TransportCounts {
    RayCounts rays;
    Traversal traversal;
    double seconds = 0;

    void add(const TransportCounts& other);
};

/// How many samples an adaptive picture gives to each pixel, row by row, and what it took to find out.
struct AdaptivePlan {
    std::vector<int> counts;
    TransportCounts spent;
};

/// How one sample becomes a summand of a pixel.
enum class Summand {
    sample,         // each for itself
    randomisation,  // the mean of all samples of the range: the variance between such means is true for every sampler
};

/// A scene made ready for distributed rays and paths. The references must outlive it.
class TransportPicture {
public:
    TransportPicture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                     const TransportOptions& options, PixelFilter filter = PixelFilter::box);
    ~TransportPicture();

    /// Adds samples to every pixel. The same bits for any number of threads.
    TransportCounts add(SampledImage& image, const Sampler& sampler, const SampleRange& range, Summand summand,
                        int threads = 0, const std::string& label = {}) const;

    /// Adds a share of as many samples to each pixel as `counts` says, row by row; each pixel's own number is spread
    /// evenly. The same bits for any number of threads.
    TransportCounts add(SampledImage& image, const Sampler& sampler, const std::vector<int>& counts, int threads = 0,
                        const std::string& label = {}, const SampleShare& share = {}) const;

    /// Where to spend sampler.count samples a pixel on the average: an eighth makes a first picture, which tells where
    /// the picture is noisy (adaptive_counts.h) and is thrown away. The same for any number of threads.
    AdaptivePlan adaptive_plan(const Sampler& sampler, int threads = 0, const std::string& label = {}) const;

    /// Adds them as they are planned.
    TransportCounts add_adaptively(SampledImage& image, const Sampler& sampler, int threads = 0,
                                   const std::string& label = {}) const;

    /// The tree of the rays of one sample: RayTree::pixel is what it adds to the pixel.
    RayTree tree(const Sampler& asked, int x, int y, int index) const;

    /// Objects that emit and are found by no light sample (AreaLights::unsampled()).
    const std::vector<std::string>& unsampled() const;

private:
    struct Stage;
    std::unique_ptr<Stage> stage_;
};

}  // namespace raylab

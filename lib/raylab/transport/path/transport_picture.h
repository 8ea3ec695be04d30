#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/sampled_image.h"
#include "raylab/sampling/pixel_filter.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/whitted/whitted.h"
#include "raylab/transport/path/transport_options.h"

#include <memory>
#include <string>
#include <vector>

namespace raylab {

/// Samples of every pixel: those numbered first to last - 1 of the sampler's.
struct SampleRange {
    int first, last;
};

/// What a number of samples took.
struct TransportCounts {
    RayCounts rays;
    Traversal traversal;
    double seconds = 0;

    void add(const TransportCounts& other);
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

    /// Adds as many samples to each pixel as `counts` says, row by row; each pixel's own number is spread evenly. The
    /// same bits for any number of threads.
    TransportCounts add(SampledImage& image, const Sampler& sampler, const std::vector<int>& counts, int threads = 0,
                        const std::string& label = {}) const;

    /// Spends sampler.count samples a pixel on the average where they are needed: an eighth makes a first picture,
    /// which tells where the picture is noisy (adaptive_counts.h) and is thrown away. The same bits for any number of
    /// threads.
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

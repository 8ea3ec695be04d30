#include "raylab/transport/path/transport_picture.h"

#include "raylab/sampling/random.h"
#include "raylab/transport/path/adaptive_counts.h"
#include "raylab/transport/path/transport_stage.h"

#include <algorithm>

namespace raylab {

void TransportCounts::add(const TransportCounts& other) {
    rays.add(other.rays);
    traversal.add(other.traversal);
    seconds += other.seconds;
}

struct TransportPicture::Stage : TransportStage<TransportModel> {
    using TransportStage::TransportStage;
};

TransportPicture::TransportPicture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                                   const TransportOptions& options, PixelFilter filter)
    : stage_(new Stage(scene, accelerator, frame, options, filter)) {}

TransportPicture::~TransportPicture() = default;

TransportCounts TransportPicture::add(SampledImage& image, const Sampler& sampler, const SampleRange& range,
                                      Summand summand, int threads, const std::string& label) const {
    return stage_->add(
        image, sampler,
        [&](int, int) {
            return SamplesOfPixel{range, sampler.count};
        },
        summand, threads, label);
}

TransportCounts TransportPicture::add(SampledImage& image, const Sampler& sampler, const std::vector<int>& counts,
                                      int threads, const std::string& label, const SampleShare& share) const {
    const auto width = static_cast<std::size_t>(image.width());
    const auto share_of_pixel = [&](int x, int y) {
        const int count = counts[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
        return SamplesOfPixel{share.range(count), count};
    };
    return stage_->add(image, sampler, share_of_pixel, Summand::sample, threads, label);
}

AdaptivePlan TransportPicture::adaptive_plan(const Sampler& sampler, int threads, const std::string& label) const {
    const int first = std::max(4, sampler.count / 8);
    const std::uint64_t other_seed = random_bits({.seed = sampler.seed, .dimension = 1});
    SampledImage tried(stage_->frame.image.width, stage_->frame.image.height);
    const TransportCounts spent =
        add(tried, {sampler.kind, first, other_seed}, {0, first}, Summand::sample, threads, label);
    return {adaptive_counts(tried, sampler.count - first), spent};
}

TransportCounts TransportPicture::add_adaptively(SampledImage& image, const Sampler& sampler, int threads,
                                                 const std::string& label) const {
    auto [counts, spent] = adaptive_plan(sampler, threads, label);
    spent.add(add(image, sampler, counts, threads, label));
    return spent;
}

RayTree TransportPicture::tree(const Sampler& asked, int x, int y, int index) const {
    const Sampler sampler = stage_->for_scene(asked);
    RayTree tree;
    Traversal traversal;
    PathTracer trace(stage_->paths, stage_->options, sampler, traversal, RecordingObserver{tree});
    tree.pixel = stage_->color(trace, sampler, stage_->place(x, y, index));
    return tree;
}

const std::vector<std::string>& TransportPicture::unsampled() const { return stage_->paths.area_lights.unsampled(); }

}  // namespace raylab

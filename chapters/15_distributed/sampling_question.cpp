#include "sampling_question.h"

#include "spread_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace raylab::spread {

namespace {

struct Effect {
    std::string name, scene;
    TransportOptions options = {};
};

std::vector<Effect> effects() {
    return {{"soft shadow", "soft_shadow"},
            {"blurry mirror", "gloss"},
            {"lens", "lens"},
            {"pixel", "filter"},
            {"all light", "colonnade", paths()}};
}

const std::map<SamplerKind, std::string> sources{
    {SamplerKind::random, "Kajiya 1986"},
    {SamplerKind::jittered, "Cook, Porter and Carpenter 1984"},
    {SamplerKind::multi_jittered, "Chiu, Shirley and Wang 1994; Kensler 2013"},
    {SamplerKind::n_rooks, "Shirley 1991"},
    {SamplerKind::halton, "Halton 1960"},
    {SamplerKind::sobol, "Sobol 1967; Owen 1995"},
    {SamplerKind::blue_noise, "Ulichney 1993; Georgiev and Fajardo 2016"},
};

std::vector<double> channels(const Image& image) {
    std::vector<double> all;
    for (const Pixel& pixel : image.pixels()) all.insert(all.end(), {pixel.r, pixel.g, pixel.b});
    return all;
}

// Root of the mean squared difference of all channels, over the truth's mean.
double relative_rmse(const Image& image, const Image& truth) {
    const std::vector<double> is = channels(image), should = channels(truth);
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < is.size(); ++i) {
        squares += (is[i] - should[i]) * (is[i] - should[i]);
        sum += should[i];
    }
    const auto values = static_cast<double>(is.size());
    return std::sqrt(squares / values) / (sum / values);
}

// One effect, and pictures of it.
class Subject {
public:
    Subject(const Effect& effect, ImageSize size)
        : scene_(scene_named(effect.scene)),
          accelerator_(make_accelerator("auto", scene_)),
          frame_(camera_frame(scene_.camera, size, scene_.source)),
          picture_(scene_, *accelerator_, frame_, effect.options) {}

    struct Timed {
        Image image;
        double nanoseconds;  // for each pixel
    };
    Timed sampled(const Sampler& sampler) const {
        SampledImage image(frame_.image.width, frame_.image.height);
        return timed(image, picture_.add(image, sampler, {0, sampler.count}, Summand::sample, 1));
    }
    Timed adaptive(const Sampler& sampler) const {
        SampledImage image(frame_.image.width, frame_.image.height);
        return timed(image, picture_.add_adaptively(image, sampler, 1));
    }

private:
    static Timed timed(const SampledImage& image, const TransportCounts& counts) {
        return {image.mean(), 1e9 * counts.seconds / (image.width() * image.height())};
    }

    const Scene scene_;
    const std::unique_ptr<Accelerator> accelerator_;
    const CameraFrame frame_;
    const TransportPicture picture_;
};

std::string best_buy(const Experiment& experiment) {
    std::string text = "The least error with the most samples: ";
    std::string separator;
    for (const Effect& effect : effects()) {
        const Measurement* best = nullptr;
        for (const Measurement& row : experiment.rows)
            if (row.workload == effect.name && (!best || row.error < best->error)) best = &row;
        if (!best) continue;
        text += fmt::format("{}{} ({})", separator, best->method, effect.name);
        separator = ", ";
    }
    return text;
}

}  // namespace

Experiment measure_sampling(const ChapterRun& run) {
    Experiment experiment{.question = "sampling",
                          .title = "How soon is a blurred picture smooth?",
                          .error_axis = "RMSE over mean radiance",
                          .rows = {},
                          .answer = best_buy};
    const ImageSize size = run.sized(ImageSize{48, 30}, ImageSize{16, 10});
    const int most = run.sized(256, 16);
    for (const Effect& effect : effects()) {
        const Subject subject(effect, size);
        const Image truth = subject.sampled({SamplerKind::sobol, 16 * most, run.seed + 1}).image;
        const auto add = [&](const std::string& method, const std::string& source, int count,
                             const Subject::Timed& picture) {
            experiment.rows.push_back(
                {.method = method,
                 .number = "double",
                 .workload = effect.name,
                 .knob = fmt::format("{} samples", count),
                 .source = source,
                 .error = relative_rmse(picture.image, truth),
                 .nanoseconds = {picture.nanoseconds, picture.nanoseconds, picture.nanoseconds},
                 .queries = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)});
        };
        for (const auto& [kind, source] : sources)
            for (int count = 4; count <= most; count *= 4)
                add(to_string(kind), source, count, subject.sampled({kind, count, run.seed}));
        for (int count = 16; count <= most; count *= 4)
            add("sobol, adaptive", "Kirk and Arvo 1991", count,
                subject.adaptive({SamplerKind::sobol, count, run.seed}));
    }
    return experiment;
}

}  // namespace raylab::spread

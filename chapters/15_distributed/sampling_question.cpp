#include "sampling_question.h"

#include "spread_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>

namespace raylab::spread {

namespace {

struct Effect {
    std::string name, scene;
    TransportOptions options = {};
};

std::vector<Effect> effects() {
    return {{"soft shadow", "soft_shadow"}, {"blurry mirror", "gloss"}, {"lens", "lens"},
            {"motion", "motion"},           {"pixel", "filter"},        {"all light", "colonnade", paths()}};
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
        double nanoseconds;  // for each pixel, of the processor: the same on a busy machine
    };
    Timed sampled(const Sampler& sampler, int threads) const {
        return timed([&](SampledImage& image) {
            picture_.add(image, sampler, {0, sampler.count}, Summand::sample, threads);
        });
    }
    Timed adaptive(const Sampler& sampler, int threads) const {
        return timed([&](SampledImage& image) { picture_.add_adaptively(image, sampler, threads); });
    }

private:
    Timed timed(const auto& draw) const {
        SampledImage image(frame_.image.width, frame_.image.height);
        const std::clock_t begun = std::clock();
        draw(image);
        const double seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
        return {image.mean(), 1e9 * seconds / (image.width() * image.height())};
    }

    const Scene scene_;
    const std::unique_ptr<Accelerator> accelerator_;
    const CameraFrame frame_;
    const TransportPicture picture_;
};

// The errors of one method's pictures with several seeds, and its times.
class Runs {
public:
    void add(double error) { squares_.push_back(error * error); }
    void add_time(double nanoseconds) { nanoseconds_.push_back(nanoseconds); }

    // The root of the mean squared error, and where it is with 95 % confidence.
    Measurement measurement() const {
        double mean = 0, variance = 0;
        const auto runs = static_cast<double>(squares_.size());
        for (const double square : squares_) mean += square / runs;
        for (const double square : squares_) variance += (square - mean) * (square - mean) / (runs - 1);
        const double reach = 1.96 * std::sqrt(variance / runs);
        return {.error = std::sqrt(mean),
                .error_interval = {{std::sqrt(std::max(mean - reach, 0.01 * mean)), std::sqrt(mean + reach)}},
                .nanoseconds = spread_of(nanoseconds_)};
    }

private:
    std::vector<double> squares_, nanoseconds_;
};

const std::string adaptive = "sobol, adaptive";

std::vector<const Measurement*> rows_of(const Experiment& experiment, const std::string& effect,
                                        const std::string& method) {
    std::vector<const Measurement*> rows;
    for (const Measurement& row : experiment.rows)
        if (row.workload == effect && row.method == method) rows.push_back(&row);
    return rows;
}

// The time that a method takes to an error, on the line through the logarithms of its two measurements that are nearest
// to it. (Their errors fall.)
double time_to(const std::vector<const Measurement*>& rows, double error) {
    std::size_t i = 1;
    while (i + 1 < rows.size() && rows[i]->error > error) ++i;
    const double slope = std::log(rows[i]->nanoseconds.median / rows[i - 1]->nanoseconds.median) /
                         std::log(rows[i]->error / rows[i - 1]->error);
    return rows[i]->nanoseconds.median * std::pow(error / rows[i]->error, slope);
}

std::string best_buy(const Experiment& experiment) {
    std::string best_text = "Least error with the most samples: ";
    std::string adaptive_text = "Time of adaptive for that of even sampling at the same error: ";
    std::string separator;
    for (const Effect& effect : effects()) {
        const Measurement* best = nullptr;
        for (const Measurement& row : experiment.rows)
            if (row.workload == effect.name && (!best || row.error < best->error)) best = &row;
        if (!best) continue;
        const auto uneven = rows_of(experiment, effect.name, adaptive);
        const double ratio = uneven.back()->nanoseconds.median /
                             time_to(rows_of(experiment, effect.name, "sobol"), uneven.back()->error);
        best_text += fmt::format("{}{} ({})", separator, best->method, effect.name);
        adaptive_text += fmt::format("{}{:.2g} ({})", separator, ratio, effect.name);
        separator = ", ";
    }
    return best_text + ". " + adaptive_text;
}

}  // namespace

Experiment measure_sampling(const ChapterRun& run) {
    Experiment experiment{.question = "sampling",
                          .title = "How soon is a blurred picture smooth? (Numbers: samples a pixel.)",
                          .error_axis = "RMSE over mean radiance",
                          .rows = {},
                          .answer = best_buy};
    const ImageSize size = run.sized(ImageSize{32, 20}, ImageSize{16, 10});
    const int most = run.sized(256, 16);
    const std::uint64_t seeds = run.sized(20, 3), timed = 3;
    for (const Effect& effect : effects()) {
        const Subject subject(effect, size);
        const Image truth = subject.sampled({SamplerKind::sobol, 16 * most, run.seed + seeds}, run.threads).image;
        const auto add = [&](const std::string& method, const std::string& source, int count, const auto& picture_of) {
            Runs runs;
            for (std::uint64_t i = 0; i < seeds; ++i) {
                const Subject::Timed picture = picture_of(run.seed + i, i < timed ? 1 : run.threads);
                runs.add(relative_rmse(picture.image, truth));
                if (i < timed) runs.add_time(picture.nanoseconds);
            }
            Measurement row = runs.measurement();
            row.method = method;
            row.number = "double";
            row.workload = effect.name;
            row.knob = std::to_string(count);
            row.source = source;
            row.queries = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
            experiment.rows.push_back(row);
        };
        for (const auto& [kind, source] : sources)
            for (int count = 4; count <= most; count *= 4)
                add(to_string(kind), source, count, [&, kind = kind](std::uint64_t seed, int threads) {
                    return subject.sampled({kind, count, seed}, threads);
                });
        for (int count = 16; count <= most; count *= 4)
            add(adaptive, "Kirk and Arvo 1991", count, [&](std::uint64_t seed, int threads) {
                return subject.adaptive({SamplerKind::sobol, count, seed}, threads);
            });
    }
    return experiment;
}

}  // namespace raylab::spread

#include "sampling_progress.h"

#include "sample_ranges.h"

#include "raylab/base/error.h"
#include "raylab/base/interrupt.h"
#include "raylab/sampling/random.h"
#include "raylab/transport/path/expected_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>

namespace raylab {

namespace {

constexpr int fewest_randomisations = 8;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) { return std::chrono::duration<double>(Clock::now() - begun).count(); }

}  // namespace

SamplingProgress::SamplingProgress(const AskedTransport& asked, std::string identity, ImageSize size)
    : asked_(asked), identity_(std::move(identity)), image_(size.width, size.height) {}

void SamplingProgress::go_on_from(const SampledFile& stored, const std::filesystem::path& file) {
    const auto text = [&](const char* name) {
        const auto found = stored.texts.find(name);
        return found == stored.texts.end() ? std::string("nothing") : found->second;
    };
    if (text(picture_text) != identity_)
        throw Error({file.string()}, "samples of this picture (" + identity_ + ")", text(picture_text));
    const SampleRanges ranges = sample_ranges(text(samples_text), file);
    const int begin = is_open_ended() ? 0 : first();
    const int end = ranges.empty() ? begin : ranges.front().last;
    if (ranges.size() > 1 || (!ranges.empty() && ranges.front().first != begin) || (!is_open_ended() && end > last()))
        throw Error({file.string()}, fmt::format("the first samples from {} on", begin), text(samples_text));
    if (stored.image.width() != image_.width() || stored.image.height() != image_.height())
        throw Error({file.string()}, fmt::format("a picture of {} x {} pixels", image_.width(), image_.height()),
                    fmt::format("{} x {}", stored.image.width(), stored.image.height()));
    image_ = stored.image;
    done_ = end - begin;
}

// What an interrupt says, and when the picture is stored.
class SamplingProgress::Watch {
public:
    Watch(const SamplingProgress& progress, const Storing& storing)
        : progress_(progress), storing_(storing), done_(progress.done_), stored_(progress.done_) {}

    // Some more samples are done; storing takes its time, too.
    void went_on() {
        done_ = progress_.done_;
        if (!storing_.store || seconds_since(last_) < 2) return;
        storing_.store();
        stored_ = progress_.done_;
        last_ = Clock::now();
    }

private:
    void tell() const {
        const std::string all = progress_.is_open_ended() ? fmt::format("{} randomisations", done_.load())
                                                          : fmt::format("{} of {} samples", done_.load(),
                                                                        progress_.last() - progress_.first());
        const std::string kept =
            stored_ == 0 ? "none is stored" : fmt::format("{} are stored{}", stored_.load(), storing_.go_on);
        std::fputs(fmt::format("raylab: stopped after {}; {}\n", all, kept).c_str(), stderr);
    }

    const SamplingProgress& progress_;
    const Storing& storing_;
    Clock::time_point last_ = Clock::now();
    std::atomic<int> done_, stored_;
    const AtInterrupt at_interrupt_{[this] { tell(); }};
};

TransportCounts SamplingProgress::run(const TransportPicture& picture, int threads, const Storing& storing) {
    TransportCounts counts;
    const auto begun = Clock::now();
    Watch watch(*this, storing);
    const auto is_done = [&] {
        if (!is_open_ended()) return done_ >= last() - first();
        if (asked_.end.seconds) return done_ > 0 && seconds_since(begun) * (done_ + 1.0) / done_ > *asked_.end.seconds;
        return done_ >= fewest_randomisations && expected_error(image_).bound <= *asked_.end.error;
    };
    while (!is_done()) {
        counts.add(is_open_ended() ? add_randomisation(picture, threads) : add_samples(picture, threads));
        watch.went_on();
    }
    return counts;
}

TransportCounts SamplingProgress::add_randomisation(const TransportPicture& picture, int threads) {
    Sampler sampler = asked_.sampler;
    sampler.seed = random_bits({.seed = sampler.seed, .pixel = static_cast<std::uint64_t>(done_)});
    ++done_;
    return picture.add(image_, sampler, {0, sampler.count}, Summand::randomisation, threads,
                       fmt::format("randomisation {}", done_));
}

TransportCounts SamplingProgress::add_samples(const TransportPicture& picture, int threads) {
    const SampleRange next{first() + done_, next_stop(range(), done_)};
    done_ = next.last - first();
    return picture.add(image_, asked_.sampler, next, Summand::sample, threads,
                       fmt::format("samples to {} of {}", done_, last() - first()));
}

// Of each pixel's samples a share after the other. No pixel gets fewer than four, so that each share is a picture.
TransportCounts SamplingProgress::run_adaptively(const TransportPicture& picture, int threads, const Storing& storing) {
    Watch watch(*this, storing);
    auto [of_pixels, counts] = picture.adaptive_plan(asked_.sampler, threads, "first samples");
    for (SampleShare share{1, 4}; share.number <= share.of; ++share.number) {
        counts.add(picture.add(image_, asked_.sampler, of_pixels, threads, "samples", share));
        done_ = share.range(asked_.sampler.count).last;
        watch.went_on();
    }
    return counts;
}

std::map<std::string, std::string> SamplingProgress::texts(const std::string& command) const {
    const int begin = is_open_ended() ? 0 : first();
    return {{picture_text, identity_},
            {samples_text, in_words(SampleRanges{{begin, begin + done_}})},
            {"raylab_command", command},
            {"raylab_seed", std::to_string(asked_.sampler.seed)}};
}

std::string SamplingProgress::words() const {
    const std::string rays = is_open_ended()
                                 ? fmt::format("{} randomisations of {} samples", done_, asked_.sampler.count)
                                 : fmt::format("{} samples", done_);
    if (image_.at(0, 0).count < 2) return rays + " each pixel; one says nothing of its error";
    const auto [error, bound] = expected_error(image_);
    return fmt::format("{} each pixel ({}); expected RMSE {:.2g} of the mean radiance, {} {:.2g}", rays,
                       to_string(asked_.sampler.kind), error,
                       is_open_ended() ? "in 95 of 100 pictures below" : "if they were independent; bound", bound);
}

}  // namespace raylab

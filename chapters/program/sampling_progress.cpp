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
constexpr int most_stops = 32;  // where a picture of known samples may be stored

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) { return std::chrono::duration<double>(Clock::now() - begun).count(); }

}  // namespace

SamplingProgress::SamplingProgress(const AskedTransport& asked, std::string identity, ImageSize size)
    : asked_(asked), identity_(std::move(identity)), image_(size.width, size.height) {}

int SamplingProgress::first() const {
    return static_cast<int>(std::int64_t{asked_.sampler.count} * (asked_.part.number - 1) / asked_.part.of);
}

int SamplingProgress::last() const {
    return static_cast<int>(std::int64_t{asked_.sampler.count} * asked_.part.number / asked_.part.of);
}

// The stops depend on the number of all samples alone, so that a picture that was interrupted and one that was not
// round their sums at the same places.
int SamplingProgress::next_stop() const {
    const int step = std::max(1, (last() - first()) / most_stops);
    return std::min(first() + (done_ / step + 1) * step, last());
}

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
    image_ = stored.image;
    done_ = end - begin;
}

TransportCounts SamplingProgress::run(const TransportPicture& picture, int threads,
                                      const std::function<void()>& store) {
    TransportCounts counts;
    const auto begun = Clock::now();
    auto stored = begun;
    std::atomic<int> shown = done_;
    const int all = is_open_ended() ? 0 : last() - first();
    const AtInterrupt tell([&shown, all] {
        if (all > 0)
            std::fprintf(stderr, "raylab: stopped after %d of %d samples; --resume goes on with what is stored\n",
                         shown.load(), all);
        else
            std::fprintf(stderr, "raylab: stopped after %d randomisations; --resume goes on with what is stored\n",
                         shown.load());
    });
    const auto is_done = [&] {
        if (!is_open_ended()) return done_ >= all;
        if (asked_.end.seconds) return done_ > 0 && seconds_since(begun) * (done_ + 1.0) / done_ > *asked_.end.seconds;
        return done_ >= fewest_randomisations && expected_error(image_).bound <= *asked_.end.error;
    };
    while (!is_done()) {
        if (is_open_ended()) {
            Sampler sampler = asked_.sampler;
            sampler.seed = random_bits({.seed = sampler.seed, .pixel = static_cast<std::uint64_t>(done_)});
            counts.add(picture.add(image_, sampler, {0, sampler.count}, Summand::randomisation, threads,
                                   fmt::format("randomisation {}", done_ + 1)));
            ++done_;
        } else {
            const int stop = next_stop();
            counts.add(picture.add(image_, asked_.sampler, {first() + done_, stop}, Summand::sample, threads,
                                   fmt::format("samples to {} of {}", stop - first(), all)));
            done_ = stop - first();
        }
        shown = done_;
        if (std::chrono::duration<double>(Clock::now() - stored).count() < 2) continue;  // storing takes its time, too
        store();
        stored = Clock::now();
    }
    return counts;
}

TransportCounts SamplingProgress::run_adaptively(const TransportPicture& picture, int threads) {
    done_ = asked_.sampler.count;
    return picture.add_adaptively(image_, asked_.sampler, threads, "samples");
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

#pragma once

#include "raylab/base/command_line.h"
#include "raylab/sampling/pixel_filter.h"
#include "raylab/sampling/sampler.h"
#include "raylab/transport/path/transport_picture.h"

#include <optional>
#include <string>

// The options of a picture whose rays are spread: by distributed ray tracing or by paths.

namespace raylab {

/// When such a picture is done.
struct SamplingEnd {
    std::optional<double> error = {};    // expected RMSE over the mean radiance
    std::optional<double> seconds = {};  // ... or after this time
};

/// A picture of spread rays as the command line asks for it.
struct AskedTransport {
    TransportOptions options;
    std::string offset = "error_bounded";  // options.start in words
    Sampler sampler;  // its count: of all samples, or of each randomisation where the end is not known beforehand
    PixelFilter filter = PixelFilter::box;
    SamplingEnd end;
    SampleShare part;
    enum class Spending { even, adaptive } spending = Spending::even;  // adaptive: more samples where it is noisy
};

/// Adds --sampler, --seed and --filter: what a sample is.
CommandLine with_sampler_options(CommandLine command_line);

/// Adds --error, --time, --adaptive, --part and --resume: which samples are taken.
CommandLine with_sampling_end_options(CommandLine command_line);

/// Reads the sampler's options, with all samples of a pixel.
AskedTransport asked_sampler(const Arguments& arguments, const Scene& scene);

/// Reads all of these options. It throws an Error for what does not go together.
AskedTransport asked_transport(const Arguments& arguments, const Scene& scene);

/// Throws an Error where one of these options is given: Whitted's model spreads no rays.
void refuse_sampler_words(const Arguments& arguments);
void refuse_sampling_end_words(const Arguments& arguments);

/// What makes a picture's samples what they are, in words: samples of pictures that differ in it do not go together.
std::string identity(const AskedTransport& asked, const Scene& scene);

}  // namespace raylab

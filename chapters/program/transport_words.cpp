#include "transport_words.h"

#include "picture_words.h"

#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/sampling/random.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

constexpr int samples_of_each = 16;  // pixel, or randomisation

std::string listed(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

PixelFilter asked_filter(const Arguments& arguments) {
    if (!arguments.has("--filter")) return PixelFilter::box;
    const auto filter = pixel_filter(arguments.text("--filter"));
    if (!filter)
        throw Error("expected --filter " + listed(filter_names()) + ", found \"" + arguments.text("--filter") + "\"");
    return *filter;
}

// "10s", "2min"
double seconds_from(const std::string& words) {
    std::size_t end = 0;
    double value = 0;
    try {
        value = std::stod(words, &end);
    } catch (const std::exception&) {
        end = 0;
    }
    const std::string unit = words.substr(end);
    const double scale = unit == "s" ? 1 : unit == "min" ? 60 : unit == "h" ? 3600 : 0;
    if (!(value > 0 && value < 1e6) || scale == 0)
        throw Error("expected --time with its unit (10s, 2min, 1h), found \"" + words + "\"");
    return value * scale;
}

SamplingEnd asked_end(const Arguments& arguments) {
    SamplingEnd end;
    if (arguments.has("--error")) {
        end.error = arguments.number("--error");
        if (!(*end.error > 0 && *end.error < 1))
            throw Error("expected --error above 0 and below 1, found " + arguments.text("--error"));
    }
    if (arguments.has("--time")) end.seconds = seconds_from(arguments.text("--time"));
    const int ends = arguments.has("--samples") + arguments.has("--error") + arguments.has("--time");
    if (ends > 1) throw Error("expected one of --samples, --error and --time, found " + std::to_string(ends));
    return end;
}

SampleShare asked_part(const Arguments& arguments, const SamplingEnd& end) {
    if (!arguments.has("--part")) return {};
    const auto numbers = two_integers(arguments.text("--part"), '/');
    if (!numbers || (*numbers)[0] < 1 || (*numbers)[0] > (*numbers)[1])
        throw Error("expected --part I/N, I from 1 to N, found \"" + arguments.text("--part") + "\"");
    if (end.error || end.seconds) throw Error("expected --part with --samples: only a known number has parts");
    return {(*numbers)[0], (*numbers)[1]};
}

// A first picture decides where samples are spent, and is thrown away: so there must be some to spare.
AskedTransport::Spending adaptive_spending(const Arguments& arguments, const AskedTransport& asked) {
    constexpr int fewest = 16;
    for (const char* other : {"--error", "--time", "--part", "--resume"})
        if (arguments.has(other)) throw Error(std::string("expected --adaptive or ") + other + ", found both");
    if (asked.sampler.count < fewest)
        throw Error(
            fmt::format("expected --samples of at least {} with --adaptive, found {}", fewest, asked.sampler.count));
    return AskedTransport::Spending::adaptive;
}

// A material of a path reflects no more than it gets.
void check_albedos(const Scene& scene) {
    for (const Material& material : scene.materials) {
        double diffuse = 0;
        const auto add = [&](const Color& c) { diffuse = std::max({diffuse, c.x, c.y, c.z}); };
        if (const auto* checker = std::get_if<Checker>(&material.diffuse)) {
            add(checker->a);
            add(checker->b);
        } else {
            add(std::get<Color>(material.diffuse));
        }
        const double sum = diffuse + material.kr + material.kt;
        if (sum > 1 + 1e-9)
            throw Error({scene.source}, "material \"" + material.name + "\" with diffuse + kr + kt <= 1, as paths need",
                        fmt::format("{:.6g}", sum));
    }
}

// Files say what a scene is: all of their bytes.
std::uint64_t bits_of(const std::filesystem::path& file) {
    std::uint64_t bits = 0;
    for (const char byte : read_file(file)) bits = mixed(bits ^ static_cast<unsigned char>(byte));
    return bits;
}

std::uint64_t bits_of(const Scene& scene) {
    std::uint64_t bits = bits_of(std::filesystem::path(scene.source));
    for (const auto& file : scene.files_read) bits = mixed(bits ^ bits_of(file));
    return bits;
}

}  // namespace

CommandLine with_sampler_options(CommandLine command_line) {
    command_line.options.insert(
        command_line.options.end(),
        {{"--sampler", "NAME", "where the samples lie: " + listed(sampler_names()) + " (default: sobol)"},
         {"--seed", "S", "another seed, other noise (default: 1)"},
         {"--filter", "NAME", "what a pixel sees around its center: " + listed(filter_names()) + " (default: box)"}});
    return command_line;
}

CommandLine with_sampling_end_options(CommandLine command_line) {
    command_line.options.insert(
        command_line.options.end(),
        {{"--error", "E", "instead of --samples: until the expected RMSE is below E times the mean radiance"},
         {"--time", "T", "instead of --samples: as good as it gets in this time: 10s, 2min"},
         {"--adaptive", "", "spend the samples where the picture is noisy: --samples are the mean of all pixels"},
         {"--resume", "", "go on with the samples that the output file already has"},
         {"--part", "I/N", "only a share of the samples, for `raylab merge`: part I of N, from 1"}});
    return command_line;
}

AskedTransport asked_sampler(const Arguments& arguments, const Scene& scene) {
    AskedTransport asked;
    asked.filter = asked_filter(arguments);
    if (arguments.has("--sampler")) asked.sampler.kind = sampler_kind(arguments.text("--sampler"));
    if (const auto seed = seed_if_given(arguments)) asked.sampler.seed = *seed;
    asked.sampler.count = asked_samples(arguments, samples_of_each);
    if (arguments.has("--depth")) asked.options.depth = static_cast<int>(arguments.integer("--depth", 1, 1'000'000));
    if (arguments.has("--fresnel")) asked.options.shares = FacetShares::fresnel;
    asked.offset = arguments.text("--offset");
    asked.options.start = ray_start_from_words(asked.offset);
    if (scene.model == RenderModel::path) {
        check_albedos(scene);
        asked.options.followed = Followed::all;
    }
    return asked;
}

AskedTransport asked_transport(const Arguments& arguments, const Scene& scene) {
    AskedTransport asked = asked_sampler(arguments, scene);
    asked.end = asked_end(arguments);
    asked.part = asked_part(arguments, asked.end);
    if (arguments.has("--adaptive")) asked.spending = adaptive_spending(arguments, asked);
    if (asked.part.of > asked.sampler.count)
        throw Error(fmt::format("expected --part of at most {} parts, one for each sample, found {}",
                                asked.sampler.count, asked.part.of));
    return asked;
}

namespace {

void refuse(const Arguments& arguments, std::initializer_list<const char*> options) {
    for (const char* option : options)
        if (arguments.has(option))
            throw Error(std::string("expected --model distributed or path with ") + option +
                        ", found Whitted's model, which spreads no rays");
}

}  // namespace

void refuse_sampler_words(const Arguments& arguments) { refuse(arguments, {"--sampler", "--seed", "--filter"}); }

void refuse_sampling_end_words(const Arguments& arguments) {
    refuse(arguments, {"--error", "--time", "--adaptive", "--part", "--resume"});
}

namespace {

std::string depth_words(const AskedTransport& asked) {
    const int depth = asked.options.depth;
    return depth == TransportOptions{}.depth ? "any depth" : fmt::format("depth {}", depth);
}

}  // namespace

std::string identity(const AskedTransport& asked, const Scene& scene) {
    const bool open_end = asked.end.error || asked.end.seconds;
    const bool is_adaptive = asked.spending == AskedTransport::Spending::adaptive;
    return fmt::format(
        "scene {:016x}, {} x {} pixels, {}, {} {} {}, seed {}, {}, {}, {}, offset {}", bits_of(scene),
        scene.image.width, scene.image.height, asked.options.followed == Followed::all ? "path" : "distributed",
        open_end      ? "randomisations of"
        : is_adaptive ? "adaptive samples"
                      : "samples",
        asked.sampler.count, to_string(asked.sampler.kind), asked.sampler.seed, to_string(asked.filter),
        depth_words(asked), asked.options.shares == FacetShares::fresnel ? "fresnel" : "kr and kt", asked.offset);
}

}  // namespace raylab

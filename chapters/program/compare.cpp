#include "commands.h"
#include "memory_words.h"

#include "raylab/base/command_line.h"
#include "raylab/base/file.h"
#include "raylab/base/outputs.h"
#include "raylab/image/compare.h"
#include "raylab/image/difference_picture.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_name.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab {

namespace {

const CommandLine compare_command_line = with_memory_option(
    {.program = "raylab compare",
     .about = "Compares IMAGE with REFERENCE and tells where they differ. Exit code 0: the same picture, 1: it differs "
              "(also in\n"
              "size, or by values that are not finite), 2: one of them cannot be read.",
     .positionals = {{"IMAGE", "EXR or PNG"}, {"REFERENCE", "EXR or PNG"}},
     .options = {{"-o,--output", "DIFF",
                  "write both pictures and their difference, with the worst pixels marked (.png or .exr)"},
                 {"--exact", "", "require the same bits, not only the same picture"},
                 {"--json", "FILE", "the numbers as JSON; - is standard output"}}});

// JSON has no NaN, so a value that is not finite is written as text.
nlohmann::json to_json(const Pixel& pixel) {
    const auto value = [](float v) {
        return std::isfinite(v) ? nlohmann::json(v) : nlohmann::json(fmt::format("{}", v));
    };
    return {value(pixel.r), value(pixel.g), value(pixel.b)};
}

nlohmann::json to_json(const std::optional<PixelAt>& pixel) {
    if (!pixel) return nullptr;
    return {{"x", pixel->x}, {"y", pixel->y}, {"value", to_json(pixel->value)}};
}

nlohmann::json to_json(const Comparison& c, const std::vector<std::string>& objections) {
    nlohmann::json json{
        {"same", objections.empty()},          {"objections", objections},
        {"size", {c.width, c.height}},         {"reference_size", {c.reference_width, c.reference_height}},
        {"non_finite", to_json(c.non_finite)}, {"reference_non_finite", to_json(c.reference_non_finite)}};
    if (c.same_size()) json["pixels_with_other_bits"] = c.bits_differ;
    if (!c.comparable()) return json;
    json.update({{"max_error", c.max_error},
                 {"rmse", c.rmse},
                 {"relative_mse", c.relative_mse},
                 {"mean_flip", c.mean_flip},
                 {"share_over_tolerance", c.share_over},
                 {"mean", to_json(c.mean)},
                 {"reference_mean", to_json(c.reference_mean)}});
    json["worst_pixels"] = nlohmann::json::array();
    for (const auto& [x, y, value, reference, error] : c.worst)
        json["worst_pixels"].push_back(
            {{"x", x}, {"y", y}, {"value", to_json(value)}, {"reference", to_json(reference)}, {"error", error}});
    json["bad_tiles"] = nlohmann::json::array();
    for (const auto& [x, y, width, height, share] : c.bad_tiles)
        json["bad_tiles"].push_back({{"x", x}, {"y", y}, {"width", width}, {"height", height}, {"share", share}});
    return json;
}

std::string numbers(const Comparison& c) {
    std::string text = fmt::format("  size                {} x {}\n", c.width, c.height);
    text += fmt::format("  largest error       {:.6g}\n  RMSE                {:.6g}\n  relative MSE        {:.6g}\n",
                        c.max_error, c.rmse, c.relative_mse);
    text += fmt::format("  mean FLIP           {:.6g}\n  over tolerance      {:.4g} % of the pixels\n", c.mean_flip,
                        100 * c.share_over);
    text += fmt::format("  other bits          {} pixels\n", c.bits_differ);
    text += fmt::format("  mean colour         {:.6g} {:.6g} {:.6g}, reference {:.6g} {:.6g} {:.6g}\n", c.mean.r,
                        c.mean.g, c.mean.b, c.reference_mean.r, c.reference_mean.g, c.reference_mean.b);
    if (!c.worst.empty()) text += "  worst pixels   error       image                              reference\n";
    const auto color = [](const Pixel& p) { return fmt::format("{:.5g} {:.5g} {:.5g}", p.r, p.g, p.b); };
    for (const auto& [x, y, value, reference, error] : c.worst)
        text += fmt::format("  {:13}  {:<10.4g}  {:33}  {}\n", fmt::format("({}, {})", x, y), error, color(value),
                            color(reference));
    return text;
}

std::string verdict(const std::vector<std::string>& objections) {
    if (objections.empty()) return "the same\n";
    std::string text = "differs\n";
    for (const auto& objection : objections) text += "  because " + objection + "\n";
    return text;
}

// The perceptual difference needs several pictures of doubles: 246 to 277 bytes per pixel were measured, both pictures
// included. It is not computed where the pictures are equal or cannot be compared.
void check_comparison(const Image& image, const Image& reference, const MemoryLimit& limit, const Place& place) {
    constexpr double bytes_a_pixel = 288;
    const bool same_size = image.width() == reference.width() && image.height() == reference.height();
    if (!same_size || image.pixels() == reference.pixels()) return;
    check_memory({.bytes = bytes_a_pixel * image.width() * image.height(),
                  .what = "a comparison",
                  .why = fmt::format("{} x {} pixels that differ", image.width(), image.height())},
                 limit, place);
}

}  // namespace

ExitCode compare_command(const std::vector<std::string>& words) {
    const Arguments arguments = parse(compare_command_line, words);
    const auto diff = arguments.text_if_given("--output"), json = arguments.text_if_given("--json");
    if (diff) check_picture_name(*diff);
    Outputs outputs(
        {.files = arguments.given({"--output", "--json"}), .inputs = arguments.given({"IMAGE", "REFERENCE"})});
    const MemoryLimit limit = memory_limit(arguments);
    const Image image = read_image(arguments.text("IMAGE"), limit);
    const auto taken = static_cast<double>(image.pixels().size() * sizeof(Pixel));
    const Image reference = read_image(arguments.text("REFERENCE"), what_is_left(limit, taken));
    check_comparison(image, reference, limit, {arguments.text("IMAGE")});
    const Comparison comparison = compare(image, reference);
    const auto found = arguments.has("--exact") ? exact_objections(comparison) : objections(comparison);
    if (diff) write_image(difference_picture(image, reference, comparison), outputs[*diff]);
    if (json) write_file(outputs[*json], to_json(comparison, found).dump(2) + "\n");
    if (json != "-") outputs.say(verdict(found) + (comparison.comparable() ? numbers(comparison) : ""));
    outputs.commit();
    return found.empty() ? ExitCode::as_it_should_be : ExitCode::negative;
}

}  // namespace raylab

#include "commands.h"
#include "memory_words.h"
#include "sample_ranges.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/image/picture_files/sampled_files.h"

#include <fmt/format.h>

namespace raylab {

namespace {

const CommandLine merge_command_line = with_memory_option(
    {.program = "raylab merge",
     .about = "Adds parts of a picture (raylab render --part I/N) to the whole: any parts, in any order.",
     .positionals = {{"PART.exr", "the parts", Positional::Count::any}},
     .options = {{"-o,--output", "FILE.exr", "the picture to write"}}});

// Reads a part, whose file says which samples of which picture it has.
SampledFile part_from(const std::string& file, const MemoryLimit& limit) {
    SampledFile part = read_sampled(file, limit);
    for (const char* name : {picture_text, samples_text})
        if (!part.texts.contains(name)) throw Error({file}, "a part of a picture", std::string("no ") + name);
    return part;
}

// Adds a part's samples to what is there already.
void add(SampledFile& sum, const SampledFile& part, const std::string& file) {
    if (sum.texts.at(picture_text) != part.texts.at(picture_text))
        throw Error({file}, "samples of the same picture (" + sum.texts.at(picture_text) + ")",
                    part.texts.at(picture_text));
    const std::string here = part.texts.at(samples_text), there = sum.texts.at(samples_text);
    const auto both = joined(sample_ranges(there, file), sample_ranges(here, file));
    if (!both) throw Error({file}, "samples that no other part has (" + there + ")", here);
    sum.image.add(part.image);
    sum.texts[samples_text] = in_words(*both);
}

}  // namespace

ExitCode merge_command(const std::vector<std::string>& words) {
    const Arguments arguments = parse(merge_command_line, words);
    const auto& files = arguments.all("PART.exr");
    const std::string& output = arguments.text("--output");
    if (std::filesystem::path(output).extension() != ".exr")
        throw Error({output}, "a name ending in .exr: other pictures keep no sums", "another");
    if (files.empty()) throw Error("expected the parts of a picture, found none");
    Outputs outputs({.files = {output}, .inputs = {files.begin(), files.end()}});
    const MemoryLimit limit = memory_limit(arguments);
    SampledFile sum = part_from(files.front(), limit);
    const double taken = 1.0 * sizeof(PixelSums) * sum.image.width() * sum.image.height();
    for (std::size_t i = 1; i < files.size(); ++i) {
        const SampledFile part = part_from(files[i], what_is_left(limit, taken));
        if (part.image.width() != sum.image.width() || part.image.height() != sum.image.height())
            throw Error({files[i]}, "a picture of the same size", "another");
        add(sum, part, files[i]);
    }
    sum.texts["raylab_command"] = "raylab merge " + fmt::format("{}", fmt::join(words, " "));
    write_sampled(sum, outputs[output]);
    outputs.say(
        fmt::format("wrote {}: samples {} of {}\n", output, sum.texts.at(samples_text), sum.texts.at(picture_text)));
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab

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

std::string text_of(const SampledFile& part, const char* name, const std::string& file) {
    const auto found = part.texts.find(name);
    if (found == part.texts.end()) throw Error({file}, "a part of a picture", std::string("no ") + name);
    return found->second;
}

// Adds a part's samples to what is there already.
void add(SampledFile& sum, const SampledFile& part, const std::string& file) {
    const auto text = [&](const SampledFile& of, const char* name) { return text_of(of, name, file); };
    if (text(sum, picture_text) != text(part, picture_text))
        throw Error({file}, "samples of the same picture (" + text(sum, picture_text) + ")", text(part, picture_text));
    const std::string here = text(part, samples_text), there = text(sum, samples_text);
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
    SampledFile sum = read_sampled(files.front(), limit);
    for (std::size_t i = 1; i < files.size(); ++i) {
        const SampledFile part = read_sampled(files[i], limit);
        if (part.image.width() != sum.image.width() || part.image.height() != sum.image.height())
            throw Error({files[i]}, "a picture of the same size", "another");
        add(sum, part, files[i]);
    }
    sum.texts["raylab_command"] = "raylab merge " + fmt::format("{}", fmt::join(words, " "));
    write_sampled(sum, outputs[output]);
    outputs.say(fmt::format("wrote {}: samples {} of {}\n", output, text_of(sum, samples_text, output),
                            text_of(sum, picture_text, output)));
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab

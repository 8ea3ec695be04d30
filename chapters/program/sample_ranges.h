#pragma once

#include "raylab/transport/path/transport_picture.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab {

/// The numbers of the samples that a picture has, in order and apart.
using SampleRanges = std::vector<SampleRange>;

/// "0-16,32-48": from the first of each range to before its last.
std::string in_words(const SampleRanges& ranges);

/// The way back. It throws an Error that names the file for any other text.
SampleRanges sample_ranges(const std::string& words, const std::filesystem::path& file);

/// Where a picture of these samples, of which it has the first `done`, may be stored next: at one of at most 32 stops,
/// so that storing takes a small share of the time. They do not depend on `done`, so a picture that was interrupted and
/// one that was not round their sums at the same places.
int next_stop(const SampleRange& all, int done);

/// Both together; absent where they share samples.
std::optional<SampleRanges> joined(SampleRanges a, const SampleRanges& b);

/// The names under which an EXR's header says which picture its samples belong to, and which samples they are.
inline constexpr auto picture_text = "raylab_picture", samples_text = "raylab_samples";

}  // namespace raylab

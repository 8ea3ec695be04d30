#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/base/output_file.h"
#include "raylab/image/sampled_image.h"

#include <filesystem>
#include <map>
#include <string>

namespace raylab {

/// A sampled picture as an EXR file has it, and what the file says of itself.
struct SampledFile {
    SampledImage image;
    std::map<std::string, std::string> texts;  // the EXR header's attributes, by name
};

/// Writes an EXR whose channels R, G and B are the mean, `variance` that of the mean luminance, `samples` their count,
/// and the others the sums, each as two floats, from which more samples can go on.
void write_sampled(const SampledFile& picture, const OutputFile& file);

/// Reads such a file. It throws an Error for a file that is none, and before it takes more memory than the limit.
SampledFile read_sampled(const std::filesystem::path& path, const MemoryLimit& limit = {});

}  // namespace raylab

#pragma once

#include "level.h"

#include "raylab/image/sampled_image.h"

#include <filesystem>
#include <string>

namespace raylab::grading {

/// A picture that a stranger made, or why there is none.
struct ForeignPicture {
    Image image;
    std::string fault = {};  // a sentence; empty: the image is there
};

/// Decodes an EXR or PNG in a process of its own, which can open nothing but that file and give nothing but pixels: a
/// decoder that a picture has taken over gains nothing. It needs isolation level 2, and has to be called before this
/// process reads an EXR itself: the threads that OpenImageIO starts then are missing in a copy, which waits for them.
ForeignPicture read_picture_apart(const std::filesystem::path& file, const Isolation& isolation);

}  // namespace raylab::grading

#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

// OpenImageIO behind a plain header. It stands in a module of its own that is loaded when it is first wanted: whoever
// links it starts 0.2 s later (260 libraries with 150 000 symbols to be found), whether it reads a picture or not.

namespace raylab::openimageio {

/// What an EXR file says of itself, channels not yet told apart.
struct Picture {
    int width = 0, height = 0, depth = 1;
    std::vector<std::string> channels = {};
};

/// What is to be read, and where it goes.
struct Wanted {
    std::array<int, 3> channels;  // by their place among Picture::channels
    float* pixels;                // three values a pixel, row after row
};

/// What the module throws.
struct Failure {
    std::string reason;  // as OpenImageIO has it
};

/// What the module can do; what fails throws Failure.
struct Functions {
    /// Reads three channels of an EXR file; `choose` sees the picture before its pixels are read, and may throw.
    void (*read_exr)(const std::string& path, const std::function<Wanted(const Picture&)>& choose);

    /// Writes an EXR of floats, linear; three values a pixel.
    void (*write_exr)(const std::string& path, int width, int height, const float* values);
};

/// Loads the module when it is first asked for. Error where it cannot.
const Functions& functions();

}  // namespace raylab::openimageio

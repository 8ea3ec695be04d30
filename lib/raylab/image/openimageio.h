#pragma once

#include <functional>
#include <string>
#include <vector>

// OpenImageIO behind a plain header. It stands in a module of its own that is loaded when it is first wanted: whoever
// links it starts 0.2 s later (260 libraries with 150 000 symbols to be found), whether it reads a picture or not.

namespace raylab::openimageio {

/// A picture file as it stands, channels not yet told apart.
struct Picture {
    int width = 0, height = 0, depth = 1;
    std::vector<std::string> channels = {};
    std::vector<float> values = {};  // row after row, pixel after pixel
};

/// What the module throws.
struct Failure {
    std::string reason;  // as OpenImageIO has it
};

/// What the module can do; what fails throws Failure.
struct Functions {
    /// Reads a file of a named format; `accept` sees the picture before memory is taken for its values, and may throw.
    Picture (*read)(const std::string& path, const std::string& format,
                    const std::function<void(const Picture&)>& accept);

    /// Writes an EXR of floats, linear; three values a pixel.
    void (*write_exr)(const std::string& path, int width, int height, const float* values);
};

/// Loads the module when it is first asked for. Error where it cannot.
const Functions& functions();

}  // namespace raylab::openimageio

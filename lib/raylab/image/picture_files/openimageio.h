#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

// OpenImageIO behind a header that does not include it. It is in a module of its own that is loaded when it is first
// needed: a program that links OpenImageIO starts 0.2 s later (260 libraries with 150 000 symbols have to be found),
// whether it reads a picture or not.

namespace raylab::openimageio {

/// The header of an EXR file, with the channels as they are named in it.
struct Picture {
    int width = 0, height = 0, depth = 1;
    std::vector<std::string> channels = {};
    std::map<std::string, std::string> texts = {};  // what the file says of itself, by name
};

/// The channels to be read, and where their values are stored.
struct Wanted {
    std::vector<int> channels;  // indices into Picture::channels
    float* values;              // one for each of them, pixel after pixel, row after row
};

/// The exception that the module throws.
struct Failure {
    std::string reason;  // in the words of OpenImageIO
};

/// The module's functions; one that fails throws Failure.
struct Functions {
    /// Reads channels of an EXR file; `choose` is called with the header before the pixels are read, and may throw.
    void (*read_exr)(const std::string& path, const std::function<Wanted(const Picture&)>& choose);

    /// Writes an EXR of linear floats; one value for each channel, pixel after pixel, row after row.
    void (*write_exr)(const std::string& path, const Picture& picture, const float* values);
};

/// Loads the module when it is first called; throws an Error where that fails.
const Functions& functions();

}  // namespace raylab::openimageio

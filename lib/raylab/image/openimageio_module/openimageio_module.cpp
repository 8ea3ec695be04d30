// The module: the only file that includes OpenImageIO's headers and is linked with its libraries.

#include "raylab/image/picture_files/openimageio.h"

#include <OpenImageIO/imageio.h>

namespace raylab::openimageio {

namespace {

Failure failure(const std::string& reason, const std::string& otherwise) {
    return {reason.empty() ? otherwise : reason};
}

// Reads the three channels in one call where they are adjacent, as in nearly all files, because each call decompresses
// the whole picture.
void read_channels(OIIO::ImageInput& input, const Wanted& wanted) {
    const auto [r, g, b] = wanted.channels;
    const OIIO::stride_t pixel = 3 * sizeof(float);
    const auto read = [&](int first, int count, float* to) {
        if (!input.read_image(0, 0, first, first + count, OIIO::TypeDesc::FLOAT, to, pixel))
            throw failure(input.geterror(), "a damaged one");
    };
    if (g == r + 1 && b == r + 2) return read(r, 3, wanted.pixels);
    for (std::size_t i = 0; i < 3; ++i) read(wanted.channels[i], 1, wanted.pixels + i);
}

void read_exr(const std::string& path, const std::function<Wanted(const Picture&)>& choose) {
    OIIO::ImageSpec spec;
    const auto input = OIIO::ImageInput::create("openexr");
    if (!input) throw failure(OIIO::geterror(), "no reader of EXR");
    if (!input->open(path, spec)) throw failure(input->geterror(), "a damaged one");
    read_channels(*input, choose({spec.width, spec.height, spec.depth, spec.channelnames}));
}

void write_exr(const std::string& path, int width, int height, const float* values) {
    const auto output = OIIO::ImageOutput::create("openexr");
    if (!output) throw failure(OIIO::geterror(), "no writer of EXR");
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");  // lossless
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("DateTime", "");  // otherwise the current date is written, and equal pictures give different files
    const bool written = output->open(path, spec) && output->write_image(spec.format, values);
    if (!output->close() || !written) throw failure(output->geterror(), "nothing of the kind");
}

}  // namespace

}  // namespace raylab::openimageio

extern "C" {
extern const raylab::openimageio::Functions raylab_openimageio;
const raylab::openimageio::Functions raylab_openimageio{raylab::openimageio::read_exr, raylab::openimageio::write_exr};
}

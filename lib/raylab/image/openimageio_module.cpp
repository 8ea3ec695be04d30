// The module: all that sees OpenImageIO's headers and libraries.

#include "raylab/image/openimageio.h"

#include <OpenImageIO/imageio.h>

namespace raylab::openimageio {

namespace {

Failure failure(const std::string& reason, const std::string& otherwise) {
    return {reason.empty() ? otherwise : reason};
}

Picture read(const std::string& path, const std::string& format, const std::function<void(const Picture&)>& accept) {
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);  // colours as they stand in the file; alpha is not looked at
    OIIO::ImageSpec spec;
    const auto input = OIIO::ImageInput::create(format);
    if (!input) throw failure(OIIO::geterror(), "no reader of " + format);
    if (!input->open(path, spec, wish)) throw failure(input->geterror(), "a damaged one");
    Picture picture{.width = spec.width, .height = spec.height, .depth = spec.depth, .channels = spec.channelnames};
    accept(picture);
    picture.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, picture.values.data()))
        throw failure(input->geterror(), "a damaged one");
    return picture;
}

void write_exr(const std::string& path, int width, int height, const float* values) {
    const auto output = OIIO::ImageOutput::create("openexr");
    if (!output) throw failure(OIIO::geterror(), "no writer of EXR");
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");  // lossless
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("DateTime", "");  // else today's is written, and equal pictures are unequal files
    const bool written = output->open(path, spec) && output->write_image(spec.format, values);
    if (!output->close() || !written) throw failure(output->geterror(), "nothing of the kind");
}

}  // namespace

}  // namespace raylab::openimageio

extern "C" {
extern const raylab::openimageio::Functions raylab_openimageio;
const raylab::openimageio::Functions raylab_openimageio{raylab::openimageio::read, raylab::openimageio::write_exr};
}

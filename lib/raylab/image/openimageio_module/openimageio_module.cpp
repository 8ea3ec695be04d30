// The module: the only file that includes OpenImageIO's headers and is linked with its libraries.

#include "raylab/image/picture_files/openimageio.h"

#include <OpenImageIO/imageio.h>

namespace raylab::openimageio {

namespace {

Failure failure(const std::string& reason, const std::string& otherwise) {
    return {reason.empty() ? otherwise : reason};
}

// Reads channels that are adjacent in one call, as they are in nearly all files, because each call decompresses the
// whole picture.
void read_channels(OIIO::ImageInput& input, const Wanted& wanted) {
    const std::vector<int>& channels = wanted.channels;
    const auto pixel = static_cast<OIIO::stride_t>(channels.size() * sizeof(float));
    for (std::size_t i = 0, end = 0; i < channels.size(); i = end) {
        for (end = i + 1; end < channels.size() && channels[end] == channels[end - 1] + 1;) ++end;
        if (!input.read_image(0, 0, channels[i], channels[end - 1] + 1, OIIO::TypeDesc::FLOAT, wanted.values + i,
                              pixel))
            throw failure(input.geterror(), "a damaged one");
    }
}

void read_exr(const std::string& path, const std::function<Wanted(const Picture&)>& choose) {
    OIIO::ImageSpec spec;
    const auto input = OIIO::ImageInput::create("openexr");
    if (!input) throw failure(OIIO::geterror(), "no reader of EXR");
    if (!input->open(path, spec)) throw failure(input->geterror(), "a damaged one");
    Picture picture{spec.width, spec.height, spec.depth, spec.channelnames};
    for (const auto& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeDesc::STRING)
            picture.texts[attribute.name().string()] = attribute.get_string();
    read_channels(*input, choose(picture));
}

void write_exr(const std::string& path, const Picture& picture, const float* values) {
    const auto output = OIIO::ImageOutput::create("openexr");
    if (!output) throw failure(OIIO::geterror(), "no writer of EXR");
    OIIO::ImageSpec spec(picture.width, picture.height, static_cast<int>(picture.channels.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames = picture.channels;
    spec.attribute("compression", "zip");  // lossless
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("DateTime", "");  // otherwise the current date is written, and equal pictures give different files
    for (const auto& [name, text] : picture.texts) spec.attribute(name, text);
    const bool written = output->open(path, spec) && output->write_image(spec.format, values);
    if (!output->close() || !written) throw failure(output->geterror(), "nothing of the kind");
}

}  // namespace

}  // namespace raylab::openimageio

extern "C" {
extern const raylab::openimageio::Functions raylab_openimageio;
const raylab::openimageio::Functions raylab_openimageio{raylab::openimageio::read_exr, raylab::openimageio::write_exr};
}

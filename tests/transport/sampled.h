#pragma once

#include "raylab/scene/read_scene.h"
#include "raylab/scene/render_model.h"
#include "raylab/transport/path/transport_picture.h"

#include <cmath>
#include <memory>
#include <string>

// Small pictures of scenes given as text, with what statistics say of them.

namespace raylab::test {

/// A scene, what finds its hits, and its picture of spread rays.
struct Sampled {
    explicit Sampled(const std::string& text, TransportOptions options = {})
        : scene(read_scene_text("raylab = 1\n" + text, "test.toml")),
          accelerator(make_accelerator("list", scene)),
          frame(camera_frame(scene.camera, scene.image)),
          picture(scene, *accelerator, frame, options) {}

    /// Independent samples, whose variance is known.
    SampledImage sampled(int samples, std::uint64_t seed = 1) const {
        SampledImage image(scene.image.width, scene.image.height);
        picture.add(image, {SamplerKind::random, samples, seed}, {0, samples}, Summand::sample);
        return image;
    }

    Scene scene;
    std::unique_ptr<Accelerator> accelerator;
    CameraFrame frame;
    TransportPicture picture;
};

inline TransportOptions paths() { return {.followed = Followed::all}; }

/// The mean of a picture's green channel over all pixels and samples, in standard errors from the truth. (All pixels
/// are expected to have the same mean.)
inline double deviations(const SampledImage& image, double truth) {
    double sum = 0, variance = 0, pixels = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x, ++pixels) {
            sum += image.at(x, y).color.g / image.at(x, y).count;
            variance += image.variance_of_mean(x, y);
        }
    return (sum / pixels - truth) / std::sqrt(variance / (pixels * pixels) + 1e-24 * truth * truth);
}

}  // namespace raylab::test

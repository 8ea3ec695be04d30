#pragma once

#include "grade.h"
#include "isolated_process.h"

#include "raylab/image/noisy_picture.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// Whole renderers, and single pictures, against reference images.

namespace raylab::grading {

/// A scene with the picture that it has.
struct PictureScene {
    std::string name;     // "02_still_life": of its files NAME.toml and NAME.exr
    std::string chapter;  // "02"
    std::string about;    // what a renderer has to know for it
    std::filesystem::path scene, reference;
    int samples = 0;  // a pixel, that a picture is taken to have; 0: it is no matter of chance
    double bias = NoisyTolerance{}.bias.relative;  // what means over windows may be off besides noise
};

/// The scenes of a folder, from its scenes.toml, in order.
std::vector<PictureScene> read_picture_scenes(const std::filesystem::path& folder);

/// What a picture is graded as.
enum class Depth { floats, eight_bits };

/// The reasons why the picture is not the scene's, by `raylab compare`'s criteria; where the scene is sampled at random
/// and its reference carries variances, by means over windows (image/noisy_picture.h). Eight bits have to agree up to
/// one level.
std::vector<std::string> picture_objections(const Image& picture, Depth depth, const PictureScene& scene);

/// What a stranger made of a scene: a picture that was decoded apart, or why there is none.
struct HandedInPicture {
    Image image;
    Depth depth = Depth::floats;
    Outcome outcome = Outcome::pass;  // other than that: there is no picture
    std::string fault = {}, details = {};
};

HandedInPicture read_picture(const std::filesystem::path& picture, const Isolation& isolation);

/// A renderer that is run as `PROGRAM SCENE.toml OUT.exr` (or OUT.png), apart from everything else.
struct StudentRenderer {
    std::filesystem::path program;
    Depth depth = Depth::floats;
    unsigned seconds = 60;  // of the processor's time, for each scene
};
HandedInPicture drawn_by(const StudentRenderer& renderer, const PictureScene& scene, const Isolation& isolation);

/// A picture as a part of a grade, without points yet; its message is the first objection. All pictures are read before
/// the first is graded: the references are opened when no stranger's process is left.
struct PictureGrade {
    Outcome outcome = Outcome::internal;
    GradePart part;
    std::string details = {};
};
PictureGrade grade_picture(const HandedInPicture& picture, const PictureScene& scene);

/// All of them as one grade: each scene is a part, and all have equal points.
Grade grade_of_pictures(const std::vector<PictureGrade>& pictures, const Isolation& isolation, Hundredths most);

}  // namespace raylab::grading

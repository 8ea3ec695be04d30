#include "whitted_words.h"

#include "raylab/base/error.h"
#include "raylab/scene/camera.h"

namespace raylab {

CommandLine with_whitted_options(CommandLine command_line) {
    command_line.options.insert(
        command_line.options.end(),
        {{"--depth", "N", "of the ray tree at most; the eye ray has depth 1", "5"},
         {"--threshold", "SHARE", "a ray that can add no more than this share to the pixel is not followed", "0"},
         {"--fresnel", "", "what transmits splits its light by the angle (Fresnel), not by kr and kt"},
         {"--viewer", "WHERE", "where highlights are seen from: local, infinity", "local"},
         {"--offset", "HOW", "how rays leave a surface: error_bounded, none, fixed:METRES, scaled:SHARE",
          "error_bounded"}});
    return command_line;
}

WhittedOptions whitted_options(const Arguments& arguments, const Scene& scene, RayRules rules) {
    const auto& viewer = arguments.text("--viewer");
    if (viewer != "local" && viewer != "infinity")
        throw Error("expected --viewer local or infinity, found \"" + viewer + "\"");
    const double threshold = arguments.number("--threshold");
    if (!(threshold >= 0 && threshold < 1)) throw Error("expected --threshold from 0 to below 1, found " + arguments.text("--threshold"));
    WhittedOptions options{.depth = static_cast<int>(arguments.integer("--depth", 1, 1000)),
                           .threshold = rules == RayRules::spd ? -1 : threshold,
                           .start = ray_start_from_words(arguments.text("--offset"))};
    if (rules == RayRules::spd) options.lit = WhittedOptions::Lit::outer_side;
    if (arguments.has("--fresnel")) options.reflectance = WhittedOptions::Reflectance::fresnel;
    if (viewer == "infinity") {
        options.viewer = WhittedOptions::Viewer::at_infinity;
        options.to_viewer = -camera_frame(scene.camera, scene.image, scene.source).forward;
    }
    return options;
}

}  // namespace raylab

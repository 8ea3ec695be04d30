#include "povray.h"

#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/image/picture_files/files.h"

#include <fmt/format.h>

using namespace raylab;

std::optional<Image> povray_picture(const Scene& scene, const PovOptions& options) {
    const auto povray = find_program("povray");
    if (povray.empty()) {
        WARN("skipped: no povray here");
        return std::nullopt;
    }
    const std::filesystem::path folder = std::filesystem::path(RAYLAB_BUILD) / "tests/render_peer";
    write_file(folder / "scene.pov", to_pov(scene, options));
    const auto [width, height] = scene.image;
    const auto result = run_process(
        povray,
        {"+Iscene.pov", "+Oscene.exr", "+FE", "-D", "-V", fmt::format("+W{}", width), fmt::format("+H{}", height)},
        {.folder = folder, .timeout = 120});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    return read_image(folder / "scene.exr");
}

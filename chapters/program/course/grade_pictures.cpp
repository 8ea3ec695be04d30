#include "course/grade.h"

#include "formats.h"
#include "picture_scenes.h"
#include "submission.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

#include <filesystem>

namespace raylab {

namespace fs = std::filesystem;
using namespace grading;

namespace {

std::vector<PictureScene> scenes_asked_for(const Arguments& arguments) {
    if (!arguments.has("--reference-dir")) {
        const fs::path scene = arguments.text("--scene");
        read_scene(scene);  // a wrong name is told before anything is judged
        PictureScene single{.name = scene.stem().string(), .scene = scene, .reference = arguments.text("--reference")};
        constexpr long long most_samples = 1'000'000;
        if (arguments.has("--samples"))
            single.samples = static_cast<int>(arguments.integer("--samples", 1, most_samples));
        return {single};
    }
    auto scenes = read_picture_scenes(arguments.text("--reference-dir"));
    if (const auto chapter = arguments.text_if_given("--chapter"))
        std::erase_if(scenes, [&](const auto& scene) { return scene.chapter != *chapter; });
    if (scenes.empty())
        throw Error("expected a chapter that has reference images, found " + arguments.text("--chapter"));
    return scenes;
}

// A picture for each scene in a folder, or the one picture of the one scene.
fs::path picture_of(const PictureScene& scene, const fs::path& picture) {
    if (!fs::is_directory(picture) || !fault_of_link(picture).empty()) return picture;
    const auto floats = picture / (scene.name + ".exr");
    return fs::exists(floats) ? floats : picture / (scene.name + ".png");
}

StudentRenderer renderer_of(const Arguments& arguments) {
    StudentRenderer renderer{.program = fs::absolute(arguments.text("--renderer"))};
    if (!fs::is_regular_file(renderer.program))
        throw Error({renderer.program.string()}, "a program that draws scenes", "nothing there");
    if (arguments.has("--png")) renderer.depth = Depth::eight_bits;
    constexpr long long most_seconds = 3600;
    if (arguments.has("--seconds"))
        renderer.seconds = static_cast<unsigned>(arguments.integer("--seconds", 1, most_seconds));
    return renderer;
}

}  // namespace

Grade graded_pictures(const Arguments& arguments, const Isolation& isolation, Hundredths most) {
    std::vector<HandedInPicture> pictures;
    const auto scenes = scenes_asked_for(arguments);
    if (arguments.has("--renderer")) {
        // Without Landlock the program could copy the references, which anybody may read.
        if (isolation.level < Level::files)
            throw Error("expected isolation level 3 for a whole renderer, found " + to_string(isolation));
        const auto renderer = renderer_of(arguments);
        for (const auto& scene : scenes) pictures.push_back(drawn_by(renderer, scene, isolation));
    } else {
        for (const auto& scene : scenes)
            pictures.push_back(read_picture(picture_of(scene, arguments.text("--picture")), isolation));
    }
    std::vector<PictureGrade> grades;
    for (std::size_t i = 0; i < scenes.size(); ++i) grades.push_back(grade_picture(pictures[i], scenes[i]));
    return grade_of_pictures(grades, isolation, most);
}

}  // namespace raylab

#include "catch.h"

#include "level.h"
#include "picture_scenes.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/read_json.h"
#include "raylab/image/picture_files/files.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <future>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

// Pictures and whole renderers against reference images.

namespace fs = std::filesystem;
using namespace raylab;
using namespace raylab::grading;

namespace {

const fs::path pictures = fs::path(RAYLAB_BUILD) / "tests/graded_pictures";
const fs::path references = fs::path(RAYLAB_SOURCE) / "reference_images/scenes";

nlohmann::ordered_json graded(const std::vector<std::string>& more) {
    std::vector<std::string> words{"grade", "--format", "json"};
    words.insert(words.end(), more.begin(), more.end());
    const auto result = run_process(RAYLAB_BUILD "/raylab", words, {.folder = RAYLAB_SOURCE, .timeout = 240});
    INFO(result.output << result.errors);
    REQUIRE(!result.output.empty());
    return json_from_text(result.output, "the result");
}

nlohmann::ordered_json graded_picture(const fs::path& picture) {
    return graded({"--scene", (references / "02_spheres.toml").string(), "--reference",
                   (references / "02_spheres.exr").string(), "--picture", picture.string()});
}

// The words of a scene's `render` in scenes.toml; of sampled ones as many samples as a renderer is asked for.
std::vector<std::string> render_words(const PictureScene& scene) {
    const auto text = read_file(references / "scenes.toml");
    std::istringstream words(text.substr(text.find("render = \"", text.find("\"" + scene.name + "\"")) + 10));
    std::vector<std::string> all{"render", scene.scene.string(), "-o", (pictures / (scene.name + ".exr")).string()};
    std::string line;
    std::getline(words, line, '"');
    std::istringstream each(line);
    for (std::string word; each >> word;) all.push_back(word);
    if (scene.samples > 0) all.insert(all.end(), {"--samples", std::to_string(scene.samples), "--seed", "2"});
    return all;
}

fs::path script(const std::string& name, const std::string& text) {
    write_file(pictures / name, "#!/bin/sh\n" + text);
    fs::permissions(pictures / name, fs::perms::owner_all | fs::perms::group_all | fs::perms::others_all);
    return pictures / name;
}

}  // namespace

TEST_CASE("every reference image is what the lab draws today, and each chapter has two at least") {
    fs::remove_all(pictures);
    fs::create_directories(pictures);
    const auto scenes = read_picture_scenes(references);
    std::map<std::string, int> of_chapter;
    std::vector<std::future<ProcessResult>> drawn;
    for (const auto& scene : scenes) {
        ++of_chapter[scene.chapter];
        drawn.push_back(std::async(std::launch::deferred, [&scene] {
            return run_process(RAYLAB_BUILD "/raylab", render_words(scene), {.timeout = 120});
        }));
    }
    CHECK(of_chapter.size() == 15);
    for (const auto& [chapter, count] : of_chapter) CHECK(count >= 2);
    for (auto& one : drawn) {
        const auto result = one.get();
        INFO(result.errors);
        REQUIRE(result.succeeded());
    }
    const auto result = graded({"--reference-dir", references.string(), "--picture", pictures.string()});
    INFO(result.dump(2));
    CHECK(result["verdict"] == "pass");
    CHECK(result["score"] == 100.0);
    CHECK(result["tests"].size() == scenes.size());
}

TEST_CASE("a picture that differs, is no number, is cut off or is none has its verdict, and its reason") {
    Image image = read_image(references / "02_spheres.exr");
    for (int y = 10; y < 26; ++y)
        for (int x = 10; x < 26; ++x) image.at(x, y).r += 0.2f;
    write_image(image, pictures / "patch.exr");
    CHECK(graded_picture(pictures / "patch.exr")["verdict"] == "wrong");
    write_image(read_image(references / "02_spheres.exr"), pictures / "eight_bits.png");
    CHECK(graded_picture(pictures / "eight_bits.png")["verdict"] == "pass");
    const auto bytes = read_file(references / "02_spheres.exr");
    write_file(pictures / "half.exr", bytes.substr(0, bytes.size() / 2));
    CHECK(graded_picture(pictures / "half.exr")["verdict"] == "no_submission");
    write_file(pictures / "none.exr", "no picture");
    const auto none = graded_picture(pictures / "none.exr");
    CHECK(none["verdict"] == "no_submission");
    CHECK(none["summary"] == "0 of 1 pictures are the same as the reference's");
    CHECK(graded_picture(pictures / "missing.exr")["verdict"] == "no_submission");
    fs::remove(pictures / "link.exr");
    fs::create_symlink(references / "02_spheres.exr", pictures / "link.exr");
    const auto link = graded_picture(pictures / "link.exr");
    CHECK(link["verdict"] == "no_submission");
    CHECK(link.dump().find("what was handed in is a symbolic link") != std::string::npos);

    // An EXR's NaN: the lab writes none, so bytes of the file are changed.
    const auto scenes = read_picture_scenes(references);
    Image unfit = read_image(references / "02_spheres.exr");
    unfit.at(3, 4).g = std::numeric_limits<float>::quiet_NaN();
    const auto objections = picture_objections(unfit, Depth::floats, scenes[2]);
    REQUIRE(objections.size() == 1);
    CHECK(objections.front().find("(3, 4)") != std::string::npos);
}

TEST_CASE("a student's whole renderer is run apart and graded scene by scene") {
    if (best_isolation().level < Level::files) {
        WARN("not tried: this kernel has no Landlock");
        return;
    }
    const auto by = [](const fs::path& program, const std::vector<std::string>& more = {"--png"}) {
        std::vector<std::string> words{"--reference-dir", references.string(), "--chapter", "01",
                                       "--renderer",      program.string()};
        words.insert(words.end(), more.begin(), more.end());
        return graded(words);
    };
    const auto right = by(RAYLAB_SOURCE "/tests/grade/student_renderer.py");
    INFO(right.dump(2));
    CHECK(right["verdict"] == "pass");
    CHECK(right["tests"].size() == 2);
    CHECK(by(script("does_nothing", "exit 0"))["verdict"] == "no_submission");
    CHECK(by(script("crashes", "kill -SEGV $$"))["verdict"] != "pass");
    CHECK(by(script("loops", "while :; do :; done"), {"--png", "--seconds", "1"})["verdict"] == "timeout");
    CHECK(by(script("fails", "echo no light >&2; exit 7"))["details"].get<std::string>().find("no light") !=
          std::string::npos);
    // It knows where the references are, and may not read them.
    const auto copies =
        by(script("copies", "cp " + references.string() + "/$(basename 01_perspective).exr \"$2\""), {});
    CHECK(copies["verdict"] == "incomplete");
    CHECK(copies["details"].get<std::string>().find("Permission denied") != std::string::npos);
}

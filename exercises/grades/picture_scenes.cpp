#include "picture_scenes.h"

#include "picture_apart.h"

#include "raylab/base/file.h"
#include "raylab/base/printable.h"
#include "raylab/base/process.h"
#include "raylab/base/temporary.h"
#include "raylab/image/compare.h"
#include "raylab/image/finite.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_files/sampled_files.h"
#include "raylab/scene/toml/toml_table.h"

#include <algorithm>
#include <csignal>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

// A level of eight bits is at most .9 % of the value beyond .2, and .0015 below.
constexpr SamePicture same_in_eight_bits{.pixel = {.absolute = 2e-3, .relative = 1e-2},
                                         .mean = {.absolute = 1e-3, .relative = 5e-3}};

Image clamped(Image image) {
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            auto& pixel = image.at(x, y);
            for (float* channel : {&pixel.r, &pixel.g, &pixel.b}) *channel = std::clamp(*channel, 0.0f, 1.0f);
        }
    return image;
}

PictureScene scene_of(const TomlTable& table, const fs::path& folder) {
    table.knows_only({"name", "chapter", "about", "render", "samples", "bias"});
    PictureScene scene{.name = table.text("name"), .chapter = table.text("chapter"), .about = table.text("about")};
    scene.samples = static_cast<int>(table.number("samples", 1e6, "a count of samples").value_or(0));
    scene.bias = table.number("bias", 1, "a share from 0 to 1").value_or(scene.bias);
    scene.scene = folder / (scene.name + ".toml");
    scene.reference = folder / (scene.name + ".exr");
    return scene;
}

GradePart part_of(const PictureScene& scene, bool passes, const std::string& message) {
    return {.name = scene.name, .right = passes ? 1u : 0u, .total = 1, .message = message};
}

PictureGrade failed(const PictureScene& scene, Outcome outcome, const std::string& message,
                    const std::string& details = {}) {
    return {outcome, part_of(scene, false, message), details};
}

Outcome outcome_of(const ProcessResult& result) {
    constexpr int cpu_limit = SIGXCPU;
    switch (result.end) {
        case ProcessResult::End::timed_out:
            return Outcome::timeout;
        case ProcessResult::End::flooded:
        case ProcessResult::End::objected:
            return Outcome::output_limit;
        case ProcessResult::End::signalled:
            if (result.code == cpu_limit || result.code == SIGKILL) return Outcome::timeout;
            return result.code == SIGSYS ? Outcome::policy : Outcome::crash;
        case ProcessResult::End::exited:
            break;
    }
    return Outcome::incomplete;
}

Outcome worst_of(const std::vector<PictureGrade>& pictures) {
    for (const auto outcome :
         {Outcome::internal, Outcome::policy, Outcome::crash, Outcome::timeout, Outcome::output_limit,
          Outcome::incomplete, Outcome::no_submission, Outcome::nonfinite, Outcome::wrong})
        if (std::ranges::find(pictures, outcome, &PictureGrade::outcome) != pictures.end()) return outcome;
    return Outcome::pass;
}

}  // namespace

std::vector<PictureScene> read_picture_scenes(const fs::path& folder) {
    const auto file = (folder / "scenes.toml").string();
    const auto root = toml_file::parse(read_file(file), file);
    std::vector<PictureScene> scenes;
    for (const auto& table : TomlTable(root, file).tables("scene")) scenes.push_back(scene_of(table, folder));
    if (scenes.empty()) throw Error({file}, "a [[scene]]", "none");
    return scenes;
}

std::vector<std::string> picture_objections(const Image& picture, Depth depth, const PictureScene& scene) {
    if (scene.samples > 0) {
        NoisyTolerance tolerance{.samples = scene.samples};
        tolerance.bias.relative = scene.bias;
        return noisy_objections(picture, read_sampled(scene.reference).image, tolerance);
    }
    const Image reference = read_image(scene.reference);
    if (depth == Depth::floats) return objections(compare(picture, reference));
    return objections(compare(picture, clamped(reference), same_in_eight_bits), same_in_eight_bits);
}

HandedInPicture read_picture(const fs::path& picture, const Isolation& isolation) {
    auto decoded = read_picture_apart(picture, isolation);
    const auto depth = picture.extension() == ".png" ? Depth::eight_bits : Depth::floats;
    if (decoded.fault.empty()) return {std::move(decoded.image), depth};
    return {{}, depth, Outcome::no_submission, std::move(decoded.fault)};
}

HandedInPicture drawn_by(const StudentRenderer& renderer, const PictureScene& scene, const Isolation& isolation) {
    const ScratchFolder scratch;
    const auto copy = scratch.path() / "scene.toml";
    const auto picture = scratch.path() / (renderer.depth == Depth::floats ? "picture.exr" : "picture.png");
    fs::copy_file(scene.scene, copy);
    const auto result = run_isolated({isolation, scratch.path()}, {Work::render, renderer.seconds}, renderer.program,
                                     {copy.string(), picture.string()}, {.folder = scratch.path()});
    if (result.succeeded()) return read_picture(picture, isolation);
    constexpr std::size_t shown = 2000;
    return {{},
            renderer.depth,
            outcome_of(result),
            "the renderer: " + to_string(result),
            printable_lines((result.errors + result.output).substr(0, shown))};
}

PictureGrade grade_picture(const HandedInPicture& picture, const PictureScene& scene) {
    if (picture.outcome != Outcome::pass) return failed(scene, picture.outcome, picture.fault, picture.details);
    const auto found = picture_objections(picture.image, picture.depth, scene);
    if (found.empty()) return {Outcome::pass, part_of(scene, true, "the same picture")};
    std::string details;
    for (const auto& objection : found) details += scene.name + ": " + objection + "\n";
    const auto outcome = first_non_finite(picture.image) ? Outcome::nonfinite : Outcome::wrong;
    return failed(scene, outcome, found.front(), details);
}

Grade grade_of_pictures(const std::vector<PictureGrade>& pictures, const Isolation& isolation, Hundredths most) {
    Grade grade{.exercise = "pictures", .outcome = worst_of(pictures), .most = most};
    grade.isolation = isolation;
    std::size_t right = 0;
    for (const auto& [outcome, part, details] : pictures) {
        grade.parts.push_back(part);
        grade.details += details;
        right += part.passed();
    }
    grade.parts = with_equal_points(std::move(grade.parts), most);
    grade.summary = fmt::format("{} of {} pictures are the same as the reference's", right, pictures.size());
    return grade;
}

}  // namespace raylab::grading

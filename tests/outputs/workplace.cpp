#include "outputs/workplace.h"

#include "catch.h"

#include "raylab/accelerator/trace_rays.h"
#include "raylab/base/file.h"
#include "raylab/image/picture_files/files.h"

#include <algorithm>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

const char* const scene =
    "raylab = 1\n[image]\nwidth = 8\nheight = 8\n[camera]\ntype = \"perspective\"\nposition = [0, 0, 5]\n"
    "target = [0, 0, 0]\nup = [0, 1, 0]\nfov_y = 40\n[material.grey]\ndiffuse = [0.5, 0.5, 0.5]\n"
    "[[light]]\ntype = \"point\"\nposition = [3, 6, 4]\ncolor = [1, 1, 1]\n"
    "[[shape]]\ntype = \"mesh\"\nfile = \"mesh.off\"\nmaterial = \"grey\"\n";

}  // namespace

Workplace::Workplace() {
    const fs::path source = RAYLAB_SOURCE;
    write_file(path() / "scene.toml", scene);
    fs::copy_file(source / "tests/scene/meshes/pyramid.off", path() / "mesh.off");
    fs::copy_file(source / "tests/stability/shared_edge.json", path() / "replay.json");
    fs::copy_file(source / "lib/raylab/geometry/slot/nearest_sphere_hit.cpp", path() / "answer.cpp");
    write_file(path() / "course.key", "sixteen bytes and more");
    write_file(path() / "rays", to_bytes(std::vector<Ray>{{{0, 0, 3}, {0, 0, -1}}}));
    for (const char* name : {"a.png", "b.png"}) write_image(Image(8, 8, {0.5f, 0.5f, 0.5f}), path() / name);
    for (const char* name : {"tree.json", "other.json"})
        REQUIRE(lab({"tree", "scene.toml", "--pixel", "4,4", "-o", name}).succeeded());
}

ProcessResult Workplace::lab(std::vector<std::string> words, const std::string& output) const {
    std::ranges::replace(words, std::string("OUTPUT"), output);
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.folder = path(), .timeout = 120});
}

std::map<std::string, std::string> Workplace::contents() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(path())) {
        const auto mode = std::to_string(static_cast<int>(entry.symlink_status().permissions())) + " ";
        auto& text = found[entry.path().lexically_relative(path()).string()];
        if (entry.is_symlink())
            text = mode + fs::read_symlink(entry.path()).string();
        else if (entry.is_regular_file())
            text = mode + read_file(entry.path());
        else
            text = mode;
    }
    return found;
}

std::string words_of(const std::vector<std::string>& words) {
    std::string text = "raylab";
    for (const auto& word : words) text += " " + word;
    return text;
}

#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/image/compare.h"
#include "raylab/image/difference_picture.h"
#include "raylab/image/files.h"
#include "raylab/scene/demo_meshes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

// What stands in a chapter's README (chapters/NN_name/pictures/*.png) and what is kept as reference
// (reference_images/NN_name/*.exr, each with a .txt on how it was made) is what the chapter's program draws today.
// Those in pictures/real_meshes are compared where the real meshes have been fetched.
// To take over a change that is meant: RAYLAB_UPDATE_PICTURES=1 ctest -R pictures, look at each picture, commit.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

const fs::path source = RAYLAB_SOURCE, build = RAYLAB_BUILD;

std::vector<fs::path> files_in(const fs::path& folder, const std::string& extension) {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == extension) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::vector<std::string> chapters() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(source / "chapters"))
        if (fs::exists(entry.path() / "main.cpp") && entry.path().filename() != "program")
            names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

// The folder that a fresh run of the chapter has filled.
fs::path told(const std::string& chapter) {
    const fs::path out = build / "tests" / "pictures_of_today";
    fs::remove_all(out / chapter);
    const auto result = run_process(build / "chapters" / chapter / chapter, {"--out", out.string(), "--only", "story"}, {.timeout = 250});
    INFO(to_string(result) << "\n" << result.errors);
    REQUIRE(result.succeeded());
    return out / chapter;
}

void check_same(const fs::path& today, const fs::path& kept) {
    INFO(today.string() << " against " << kept.string());
    if (std::getenv("RAYLAB_UPDATE_PICTURES")) fs::copy_file(today, kept, fs::copy_options::overwrite_existing);
    REQUIRE(fs::exists(today));
    const Image now = read_image(today), then = read_image(kept);
    const Comparison comparison = compare(now, then);
    const auto found = objections(comparison);
    if (found.empty()) return;
    fs::path difference = today;
    difference.replace_filename(today.stem().string() + "_difference.png");
    write_image(difference_picture(now, then, comparison), difference);
    for (const auto& objection : found) FAIL_CHECK(objection << "; see " << difference.string());
}

}  // namespace

TEST_CASE("every picture in a chapter's README and every reference image is what the chapter draws today") {
    for (const std::string& chapter : chapters()) {
        auto shown = files_in(source / "chapters" / chapter / "pictures", ".png");
        const auto of_meshes = files_in(source / "chapters" / chapter / "pictures/real_meshes", ".png");
        if (demo_mesh("elephant"))
            shown.insert(shown.end(), of_meshes.begin(), of_meshes.end());
        else if (!of_meshes.empty())
            WARN(chapter << ": the pictures of real meshes are not compared, since the meshes have not been fetched");
        const auto references = files_in(source / "reference_images" / chapter, ".exr");
        if (shown.empty() && references.empty()) continue;
        const fs::path today = told(chapter);
        for (const auto& kept : shown) check_same(today / kept.filename(), kept);
        for (const auto& kept : references) check_same(today / kept.filename(), kept);
    }
}

TEST_CASE("every reference image tells how it was made") {
    for (const std::string& chapter : chapters())
        for (fs::path kept : files_in(source / "reference_images" / chapter, ".exr")) {
            INFO(kept.string());
            CHECK(fs::exists(kept.replace_extension(".txt")));
        }
}

TEST_CASE("every picture that a README names is there, and no other") {
    for (const std::string& chapter : chapters()) {
        const fs::path folder = source / "chapters" / chapter;
        if (!fs::exists(folder / "README.md")) continue;
        const std::string readme = read_file(folder / "README.md");
        for (const auto& picture : files_in(folder / "pictures", ".png")) {
            INFO(picture.string());
            CHECK(readme.find("pictures/" + picture.filename().string()) != std::string::npos);
        }
        for (std::size_t at = readme.find("](pictures/"); at != std::string::npos; at = readme.find("](pictures/", at + 1)) {
            const std::size_t start = at + 2, end = readme.find(')', start);
            INFO(readme.substr(start, end - start));
            CHECK(fs::exists(folder / readme.substr(start, end - start)));
        }
    }
}

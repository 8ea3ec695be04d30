#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/temporary.h"

#include <filesystem>
#include <string>

// The script `raylab`, in a project whose program was built and only tells from where it was called, with which words.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

class Launcher {
public:
    Launcher() {
        fs::create_directories(elsewhere());
        for (const auto* folder : {"cmake", "lib", "chapters", "exercises", "tests", "build/meshes"})
            fs::create_directories(project() / folder);
        fs::copy_file(fs::path(RAYLAB_SOURCE) / "raylab", project() / "raylab");
        write_file(project() / "CMakeLists.txt", "");
        const auto built = project() / "build/release";
        write_file(built / "build.ninja", "");
        write_file(built / "raylab", "#!/bin/sh\necho \"$PWD: $*\"\n");
        fs::permissions(built / "raylab", fs::perms::owner_all);
        write_file(built / ".built-lab", "");  // newer than all sources: nothing is to be built
        write_file(project() / "build/.installed-lab", "");
    }

    fs::path project() const { return fs::canonical(folder_.path()) / "project"; }
    fs::path elsewhere() const { return fs::canonical(folder_.path()) / "elsewhere"; }

    std::string said_from(const fs::path& folder, const std::vector<std::string>& words) const {
        const auto result = run_process(project() / "raylab", words, {.folder = folder, .timeout = 20});
        INFO(result.errors);
        CHECK(result.succeeded());
        return result.output;
    }

private:
    ScratchFolder folder_;
};

}  // namespace

TEST_CASE("the files of every command are named from where the person stands") {
    const Launcher launcher;
    const auto here = launcher.elsewhere().string();
    for (const auto* command : {"render", "merge", "radiosity", "form-factor", "needs", "tree", "compare", "trace",
                                "export", "bench", "chart", "stability", "check", "watch", "grade", "handout"})
        CHECK(launcher.said_from(here, {command, "a.toml", "-o", "b.png"}) ==
              here + ": " + command + " a.toml -o b.png\n");
    CHECK(launcher.said_from(here, {"chapter", "07", "--scene", "a.toml", "--out", "b"}) ==
          here + ": chapter 07 --scene a.toml --out b\n");
    CHECK(launcher.said_from(here, {"slides", "07", "--book=b"}) == here + ": slides 07 --book=b\n");
}

TEST_CASE("the lab book is in the project where no folder is named for it") {
    const Launcher launcher;
    const auto here = launcher.elsewhere().string(), out = (launcher.project() / "out").string();
    CHECK(launcher.said_from(here, {}) == here + ": tour --out " + out + "\n");
    CHECK(launcher.said_from(here, {"tour", "--quick"}) == here + ": tour --quick --out " + out + "\n");
    CHECK(launcher.said_from(here, {"chapter", "07"}) == here + ": chapter 07 --out " + out + "\n");
    CHECK(launcher.said_from(here, {"slides", "07", "-o", "a.html"}) ==
          here + ": slides 07 -o a.html --book " + out + "\n");
    CHECK(launcher.said_from(here, {"stability", "accelerators"}) ==
          here + ": stability accelerators --out " + out + "/differences\n");
    CHECK(launcher.said_from(here, {"chapter", "--help"}) == here + ": chapter --help --out " + out + "\n");
}

TEST_CASE("in the project every command is passed on as it is typed") {
    const Launcher launcher;
    const auto project = launcher.project().string();
    CHECK(launcher.said_from(project, {}) == project + ": tour\n");
    CHECK(launcher.said_from(project, {"chapter", "07"}) == project + ": chapter 07\n");
    CHECK(launcher.said_from(project, {"render", "a.toml"}) == project + ": render a.toml\n");
}

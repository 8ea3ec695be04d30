#include "raylab/report/build_target.h"

#include "catch.h"
#include "report/on_path.h"

#include "raylab/base/error.h"

#include <unistd.h>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("raylab_build_target_" + std::to_string(getpid()));
    ~Folder() { fs::remove_all(path); }
};

}  // namespace

TEST_CASE("a compiler that does not end is ended, and the message names the target and the limit") {
    const Folder folder;
    const OnPath ninja(folder.path, "ninja", "sleep 77");
    CHECK_THROWS_WITH(build_target("some_program", 0.2),
                      "expected to build some_program, found: the compiler did not end within 0.2 seconds");
}

TEST_CASE("a target is built by its name in the lab's own build folder") {
    const Folder folder;
    const OnPath ninja(folder.path, "ninja", "echo \"$@\"");
    CHECK(build_target("some_program").output == "-C " RAYLAB_BUILD " --quiet some_program\n");
}

TEST_CASE("without ninja the message says so") {
    const std::string path = getenv("PATH");
    setenv("PATH", "/nonexistent", 1);
    CHECK_THROWS_WITH(build_target("some_program"), "expected ninja on the PATH, to build some_program; found none");
    setenv("PATH", path.c_str(), 1);
}

#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/temporary.h"

#include <cstdlib>
#include <filesystem>
#include <string>

// `raylab doctor` on a machine whose tools are there, but do not work.

using namespace raylab;
namespace fs = std::filesystem;

TEST_CASE("a tool that ends badly when it is asked for its version is missing, and how it ended is told") {
    const ScratchFolder tools;
    write_file(tools.path() / "cmake", "#!/bin/sh\necho cmake version 3\nkill -SEGV $$\n");
    write_file(tools.path() / "ccache", "#!/bin/sh\necho ccache version 4\nexit 3\n");
    for (const auto* tool : {"cmake", "ccache"}) fs::permissions(tools.path() / tool, fs::perms::owner_all);
    const auto doctor = run_process(
        "env", {"PATH=" + tools.path().string() + ":" + std::getenv("PATH"), RAYLAB_BUILD "/raylab", "doctor"});
    INFO(doctor.output << doctor.errors);
    CHECK(doctor.code == 1);
    CHECK_THAT(doctor.output, Catch::Contains("✗ missing  cmake         "));
    CHECK_THAT(doctor.output, Catch::Contains("cmake: killed by signal 11"));
    CHECK_THAT(doctor.output, Catch::Contains("- absent   ccache        "));
    CHECK_THAT(doctor.output, Catch::Contains("ccache: exit code 3"));
}

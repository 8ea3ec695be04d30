#include "catch.h"
#include "render/program.h"

#include "raylab/base/file.h"
#include "raylab/base/temporary.h"

// Tests of slurm/array.sbatch, with a program that only says how it was called.

using namespace raylab;
using namespace raylab::test;

namespace {

std::string called(const std::string& words) {
    const ScratchFolder folder;
    const auto program = folder.path() / "build/release/raylab";
    std::filesystem::create_directories(program.parent_path());
    write_file(program, "#!/bin/sh\necho \"$@\"\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const std::string command = "SLURM_SUBMIT_DIR=" + folder.path().string() +
                                " SLURM_ARRAY_TASK_ID=3 SLURM_ARRAY_TASK_COUNT=4 "
                                "bash " RAYLAB_SOURCE "/slurm/array.sbatch " +
                                words;
    return run_process("/bin/sh", {"-c", command}, {.timeout = 60}).output;
}

}  // namespace

TEST_CASE("each part of an array writes a picture of its own, however its name is given") {
    for (const std::string output : {"-o x.exr", "--output x.exr", "--output=x.exr", "-ox.exr"}) {
        const std::string own = output.substr(0, output.size() - 5) + "x.part_3.exr";
        CHECK(called("render s.toml " + output + " --samples 8") ==
              "render s.toml " + own + " --samples 8 --part 3/4\n");
    }
    CHECK(called("grade 02 -o REPORT") == "grade 02 -o REPORT --part 3/4\n");
}

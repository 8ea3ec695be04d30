#include "catch.h"
#include "streams/program.h"

#include "raylab/base/file.h"

#include <array>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

/// A folder for the PATH that contains one program, a script.
fs::path folder_with(const std::string& program, const std::string& script) {
    const auto folder = streams_folder / "programs";
    fs::remove_all(folder);
    write_file(folder / program, "#!/bin/sh\n" + script + "\n");
    fs::permissions(folder / program, fs::perms::owner_all);
    return folder;
}

Around with_program(const std::string& program, const std::string& script) {
    return {.prefix = "PATH='" + folder_with(program, script).string() + "':$PATH;"};
}

// A chart of curves, which gnuplot draws.
const std::vector<std::string> curves = {
    "chapter", "07", "--quick", "--figure", "fresnel_curves", "--out", streams_folder / "chart"};

// A chart that is made in a folder for temporary files.
const std::vector<std::string> chart = {"chart", "phong_specular", "--quick", "-o", streams_folder / "chart"};

}  // namespace

TEST_CASE("a gnuplot that fails is one line that names the chart and the cause, and no temporary") {
    const auto result = in_shell(
        curves,
        with_program("gnuplot", "echo 'gnuplot> plot x' >&2; echo '         line 7: no such thing' >&2; exit 1"));
    check_could_not(
        result,
        "07_recursion/fresnel_curves.svg: expected a picture, found gnuplot: exit code 1: line 7: no such thing");
    std::string but_for_the_chart = result.errors;
    const std::string folder = streams_folder;  // a checkout may be anywhere, below /tmp, too
    but_for_the_chart.erase(std::min(but_for_the_chart.find(folder), but_for_the_chart.size()), folder.size());
    CHECK_THAT(but_for_the_chart, !Catch::Contains("/tmp") && !Catch::Contains("/."));
}

TEST_CASE("a gnuplot that dies is one line") {
    check_could_not(in_shell(curves, with_program("gnuplot", "kill -SEGV $$")), "gnuplot: killed by signal 11");
}

TEST_CASE("no folder for temporary files, or a full one, is one line") {
    check_could_not(in_shell(chart, {.prefix = "TMPDIR=/no/such/folder"}),
                    "TMPDIR: expected a folder for temporary files, found No such file or directory");
    check_could_not(in_shell({"stability", "FAR-SPHERE", "--quick"}, {.prefix = "TMPDIR=/no/such/folder"}),
                    "TMPDIR: expected");
    if (run_process("unshare", {"-m", "true"}).code != 0) {
        WARN("skipped: no mount of our own is permitted");
        return;
    }
    fs::create_directories(streams_folder / "full");
    const std::string full =
        "unshare -m sh -c 'mount -t tmpfs -o size=8k tmpfs full && TMPDIR=$PWD/full exec \"$@\"' sh";
    const auto result = in_shell(chart, {.prefix = full});
    check_could_not(result, "phong_specular");
    CHECK_THAT(result.errors, Catch::Contains("No space left on device"));
    CHECK_THAT(result.errors, !Catch::Contains("raylab.") && !Catch::Contains("/."));
}

TEST_CASE("a compiler that fails is one line, and bench's own words are refused before it is asked") {
    const auto around = with_program("ninja", "echo FAILED; echo 'no such header' >&2; exit 1");
    check_could_not(in_shell({"bench", "--meshes", "bumpy_0"}, around),
                    "building raylab_bench: exit code 1: no such header");
    for (const auto& [option, word, fragment] :
         std::vector<std::array<std::string, 3>>{{"--meshes", "teacup", "expected a mesh"},
                                                 {"--meshes", "no/such.off", "no/such.off: expected a mesh file"},
                                                 {"--rays", "heat", "expected a kind of rays"},
                                                 {"--peers", "wishful", "expected a peer"},
                                                 {"--peers", "grid:many", "expected grid: and a number"},
                                                 {"--threads", "none", "--threads: expected"},
                                                 {"--clock", "sun", "--clock: expected"},
                                                 {"--size", "0", "--size"},
                                                 {"--repetitions", "none", "--repetitions"}}) {
        INFO(option << " " << word);
        check_could_not(in_shell({"bench", option, word}, around), fragment);
    }
}

#include "catch.h"
#include "says.h"

#include "exercise.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <algorithm>
#include <filesystem>

// Tests that a wrong picture leads to the ray that goes wrong first: for every exercise whose slot is in the textbook's
// tracer, with one of its typical mistakes.

namespace fs = std::filesystem;
using namespace raylab;

namespace {

const fs::path out = fs::path(RAYLAB_BUILD) / "tests/way_home";

ProcessResult check(const std::string& exercise, const fs::path& answer) {
    return run_process(fs::path(RAYLAB_BUILD) / "raylab",
                       {"check", exercise, "--answer", answer.string(), "--out", out.string()},
                       {.folder = RAYLAB_SOURCE, .timeout = 240});
}

// The exercise's mistake that says of itself that it shows in the traced scene.
fs::path shown_mistake(const grading::Exercise& exercise) {
    const auto mistakes = fs::path(RAYLAB_SOURCE) / "exercises" / exercise.folder / "mistakes";
    for (const auto& mistake : exercise.mistakes) {
        const auto file = mistakes / (mistake.name + ".cpp");
        if (read_file(file).find("\n// It shows in the traced scene.\n") != std::string::npos) return file;
    }
    FAIL(mistakes.string() << ": expected a file with the line \"// It shows in the traced scene.\", found none");
    return {};
}

}  // namespace

TEST_CASE("a failing picture leads to its worst pixel, its ray, and the first node of its tree that differs") {
    for (const auto& exercise : grading::exercises()) {
        if (!exercise.traced) continue;
        const auto folder = out / exercise.folder;
        fs::remove_all(folder);
        const auto result = check(exercise.folder, shown_mistake(exercise));
        INFO(exercise.folder << "\n" << result.output << result.errors);
        CHECK(result.code == 1);
        CHECK(says(result, "Its worst pixel is ("));
        CHECK(says(result, "the first node that differs is the "));
        CHECK(says(result, " expected "));
        CHECK(says(result, (folder / "ray_trees.svg").string()));
        CHECK(fs::exists(folder / "traced.png"));
        CHECK(read_file(folder / "ray_trees.svg").find("FIRST DIFFERENCE") != std::string::npos);
        const auto again = run_process(fs::path(RAYLAB_BUILD) / "raylab",
                                       {"tree", (folder / "ray_tree_yours.json").string(), "--against",
                                        (folder / "ray_tree_reference.json").string()});
        CHECK(again.code == 1);
        CHECK(says(again, "the first node that differs"));
    }
}

TEST_CASE("rays that cost time and change no pixel are found by their trees") {
    const auto result = check("07b", RAYLAB_SOURCE "/exercises/07b_trace/mistakes/traces_for_nothing.cpp");
    INFO(result.output << result.errors);
    CHECK(says(result, "The pictures are the same, the rays are not"));
    CHECK(says(result, "branch expected none, got reflected ray"));
}

TEST_CASE("a direction that is no number is told as that, and not as the other ray") {
    const auto refracted = out / "refracts_to_nowhere.cpp";
    write_file(refracted,
               "#include \"raylab/tracer/refracted_direction.h\"\n#include <limits>\n"
               "std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d&, const Vec3d&, double, "
               "double) {\n    return Vec3d(std::numeric_limits<double>::quiet_NaN());\n}\n");
    const auto traced = out / "traces_to_nowhere.cpp";
    write_file(traced,
               "#include \"raylab/tracer/traced_color.h\"\n#include <limits>\n"
               "raylab::Vec3d raylab::traced_color(const TracedLevel& level) {\n"
               "    if (!level.nearest) return level.background;\n"
               "    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;\n"
               "    Vec3d color = local;\n"
               "    if (level.depth >= level.limit) return color;\n"
               "    const double mirror = kr + (refracted ? 0 : kt);\n"
               "    if (mirror > 0) color += mirror * level.trace(mirrored, level.depth + 1);\n"
               "    if (refracted && kt > 0)\n"
               "        color += kt * level.trace(Vec3d(std::numeric_limits<double>::quiet_NaN()), level.depth + "
               "1);\n    return color;\n}\n");
    for (const auto& [exercise, answer] : {std::pair{"07", refracted}, {"07b", traced}}) {
        const auto result = check(exercise, answer);
        INFO(result.output << result.errors);
        CHECK(says(result, "'s transmitted ray:"));
        CHECK(says(result, ", got (nan, nan, nan)"));
    }
}

TEST_CASE("an answer that passes is led nowhere") {
    const auto result = check("07b", RAYLAB_SOURCE "/exercises/07b_trace/right/refracted_first.cpp");
    INFO(result.output << result.errors);
    CHECK(result.code == 0);
    CHECK_FALSE(says(result, "worst pixel"));
}

TEST_CASE("a tracer that cannot end by itself is stopped, and said to be") {
    const auto answer = fs::path(RAYLAB_BUILD) / "tests/answers/loops_in_the_picture.cpp";
    write_file(answer,
               "#include \"raylab/tracer/traced_color.h\"\n"
               "raylab::Vec3d raylab::traced_color(const TracedLevel& level) {\n"
               "    for (volatile int i = 0; level.nearest && level.limit == 5 && level.depth == 1; i = i + 1) {}\n"
               "    return level.background;\n}\n");
    const auto result = check("07b", answer);
    INFO(result.output << result.errors);
    CHECK(result.code == 1);
    CHECK((says(result, "takes too long")));
}

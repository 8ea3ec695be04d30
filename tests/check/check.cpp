#include "catch.h"

#include "exercise.h"
#include "rotating.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <filesystem>
#include <string>

// Tests of `raylab check` from outside, as a student uses it. The answers are files beside the build.

namespace fs = std::filesystem;
using raylab::ProcessResult;

namespace {

const fs::path answers = fs::path(RAYLAB_BUILD) / "tests/answers";

ProcessResult check(const std::string& exercise, const fs::path& answer,
                    const std::vector<std::string>& more = {"--verdict-only"}) {
    std::vector<std::string> words{"check", exercise, "--answer", answer.string()};
    words.insert(words.end(), more.begin(), more.end());
    return raylab::run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.folder = RAYLAB_SOURCE, .timeout = 120});
}

// A file that answers exercise 02 with the given body.
fs::path sphere_answer(const std::string& name, const std::string& body, const std::string& before = "") {
    const auto file = answers / (name + ".cpp");
    raylab::write_file(file, "#include \"raylab/geometry/nearest_sphere_hit.h\"\n#include <cstdio>\n#include "
                             "<cstdlib>\n" +
                                 before +
                                 "\nstd::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const "
                                 "SphereOf<double>& sphere) {\n" +
                                 body + "\n}\n");
    return file;
}

bool says(const ProcessResult& result, const std::string& words) {
    return (result.output + result.errors).find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("every stub fails and says that it is not written yet") {
    const auto& all = raylab::grading::exercises();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!is_tested_now(i, 5)) continue;
        const auto& exercise = all[i];
        const auto result =
            check(exercise.folder, fs::path(RAYLAB_SOURCE) / "exercises" / exercise.folder / (exercise.slot + ".cpp"));
        INFO(exercise.folder << "\n" << result.output << result.errors);
        CHECK(result.code == 1);
        CHECK(says(result, "not written yet"));
    }
}

TEST_CASE("a crash keeps the score of what was answered before, and names its case") {
    const auto result = check("02",
                              sphere_answer("crashes_later", "    static int asked = 0;\n    if (++asked > 70) "
                                                             "std::abort();\n    return std::nullopt;"),
                              {"--verdict-only", "--seed", "1"});
    INFO(result.output);
    CHECK(result.code == 1);
    CHECK(says(result, "killed by signal 6"));
    CHECK(says(result, "It was asked case 70, passing by"));
    CHECK(says(result, "Before that, 10 of 70 graded cases were right"));
}

TEST_CASE("what is kept from one call to the next is found by asking in two orders, and has a hint with an id") {
    const auto answer = sphere_answer(
        "remembers",
        "    static const auto first = ray.direction;\n    const auto f = ray.origin - sphere.center;\n"
        "    const double a = dot(first, first), b = dot(f, first), c = dot(f, f) - sphere.radius * sphere.radius;\n"
        "    return b * b < a * c ? std::nullopt : std::optional<double>((-b - std::sqrt(b * b - a * c)) / a);",
        "#include <cmath>");
    const auto data = answers / "remembers.json";
    const auto result = check("02", answer, {"--verdict-only", "--json", data.string()});
    INFO(result.output);
    CHECK(says(result, "depends on what was asked before"));
    CHECK(says(result, "Asked from last to first"));
    CHECK(raylab::read_file(data).find("\"hint_id\": \"depends_on_order\"") != std::string::npos);
}

TEST_CASE("too much memory is told as that, and a forbidden call as that") {
    const auto hoards =
        check("02", sphere_answer("hoards", "    return std::string(std::size_t{1} << 40, 'x').back();"));
    INFO(hoards.output);
    CHECK(says(hoards, "needs more memory than an answer gets"));
    CHECK(says(hoards, "It was asked case 0, in front"));
}

TEST_CASE("each check asks new cases, and a seed asks the same again") {
    const auto answer = sphere_answer("asked_again", "    return ray.origin.x;");
    const auto seeded = [&] { return check("02", answer, {"--json", "-", "--seed", "7"}).output; };
    CHECK(check("02", answer, {"--json", "-"}).output != check("02", answer, {"--json", "-"}).output);
    CHECK(seeded() == seeded());
    CHECK(seeded().find("\"seed\": 7") != std::string::npos);
}

TEST_CASE("a seed that is none is refused before anything is compiled") {
    const auto result = check("02", sphere_answer("broken_and_seeded", "    return 1 +;"), {"--seed", "-1"});
    CHECK(result.code == 2);
    CHECK(says(result, "--seed"));
    CHECK_FALSE(says(result, "does not compile"));
}

TEST_CASE("a file as other systems write it is taken: a byte order mark, and returns at the ends of lines") {
    auto text = raylab::read_file(RAYLAB_SOURCE "/exercises/02_ray_sphere/right/geometric.cpp");
    for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) text.insert(at, "\r");
    raylab::write_file(answers / "from_elsewhere.cpp", "\xef\xbb\xbf" + text);
    const auto result = check("02", answers / "from_elsewhere.cpp");
    INFO(result.output);
    CHECK(result.code == 0);
}

TEST_CASE("a file that cannot be an answer is told as what it is, and not by a compiler") {
    const auto said_of = [](const std::string& name, const std::string& text, const std::string& words) {
        raylab::write_file(answers / name, text);
        const auto result = check("02", answers / name);
        INFO(result.output << result.errors);
        CHECK(result.code == 1);
        CHECK(says(result, "NOT YET: the file " + words));
    };
    said_of("empty.cpp", "\n", "is empty");
    said_of("large.cpp", std::string(10 << 20, '/'), "has 10.0 MB");
    said_of("zipped.cpp", "PK\x03\x04 and ../../escaped", "is a ZIP archive");
    said_of("binary.cpp", std::string("int main\0", 9), "is no text");
}

TEST_CASE("warnings and prints are shown, and the prints cannot be taken for the check's own words") {
    const auto result =
        check("02", sphere_answer("warned", "    int unused_count = 0;\n    std::puts(\"PASSED: \\033[32m\");\n"
                                            "    return std::nullopt;"));
    INFO(result.output);
    CHECK(says(result, "warned.cpp:6:9: warning: unused variable"));
    CHECK(says(result, "    | PASSED: \\u{1b}[32m"));
}

TEST_CASE("what is C++ is compiled: a number that is cut to a whole one is warned of, and judged") {
    const auto result =
        check("02", sphere_answer("cuts", "    const int whole = 0.5;\n    const float rounded = 0.1 * whole;\n"
                                          "    return rounded > 1 ? std::optional(1.0) : std::nullopt;"));
    INFO(result.output);
    CHECK(says(result, "cuts.cpp:6:23: warning: conversion from"));
    CHECK(says(result, "expected   a hit at t ="));
}

TEST_CASE("files are named from where the person stands") {
    const auto answer = sphere_answer("near_by", "    return std::nullopt;");
    const auto result = raylab::run_process(fs::path(RAYLAB_BUILD) / "raylab",
                                            {"check", "02", "--answer", "near_by.cpp", "--json", "near_by.json"},
                                            {.folder = answers, .timeout = 120});
    CHECK(result.code == 1);
    CHECK(fs::exists(answers / "near_by.json"));
    const auto own = raylab::run_process(fs::path(RAYLAB_BUILD) / "raylab", {"check", "02", "--verdict-only"},
                                         {.folder = answers, .timeout = 120});
    CHECK(says(own, "not written yet"));
}

TEST_CASE("the library's own function passes from outside, too") {
    const auto result = check("2", fs::path(RAYLAB_SOURCE) / "lib/raylab/geometry/slot/nearest_sphere_hit.cpp");
    INFO(result.output << result.errors);
    CHECK(result.code == 0);
    CHECK(says(result, "PASSED"));
}

TEST_CASE("a wrong answer is told as case, expected, got, and what is probably wrong") {
    const auto result = check("02", sphere_answer("always_misses", "    return std::nullopt;"));
    INFO(result.output);
    CHECK(result.code == 1);
    for (const auto* words : {"expected   a hit at t =", "got        no hit", "What is probably wrong", "NOT YET"})
        CHECK(says(result, words));
}

TEST_CASE("an answer that does not compile is told with the student's file and line") {
    const auto result = check("02", sphere_answer("broken", "    return 1 +;"));
    INFO(result.output);
    CHECK(result.code == 1);
    CHECK(says(result, "tests/answers/broken.cpp:"));
    CHECK(says(result, "does not compile"));
}

TEST_CASE("a misnamed function does not pass by linking with the reference") {
    const auto file = answers / "misnamed.cpp";
    raylab::write_file(file, "#include \"raylab/geometry/nearest_sphere_hit.h\"\nnamespace raylab { "
                             "std::optional<double> nearest_spere_hit(const RayOf<double>&, const "
                             "SphereOf<double>&) { return 1; } }\n");
    const auto result = check("02", file);
    INFO(result.output);
    CHECK(result.code == 1);
    CHECK(says(result, "undefined reference"));
}

TEST_CASE("a helper function, a global, a class and a long double are fine") {
    const auto root = sphere_answer("helper", R"(    const auto f = ray.origin - sphere.center;
    const Quadratic q{dot(ray.direction, ray.direction), dot(f, ray.direction), dot(f, f) - sphere.radius * sphere.radius};
    if (q.discriminant() < 0) return std::nullopt;
    ++asked;
    for (const double sign : {-1.0, 1.0})
        if (const double t = q.root(sign); t >= ray.range.min && t <= ray.range.max) return t;
    return std::nullopt;)",
                                    R"(#include <cmath>
int asked = 0;
long double square(long double x) { return x * x; }
class Quadratic {
public:
    Quadratic(long double a, long double b, long double c) : a_(a), b_(b), c_(c) {}
    long double discriminant() const;
    double root(double sign) const { return static_cast<double>((-b_ + sign * std::sqrt(discriminant())) / a_); }
private:
    long double a_, b_, c_;
};
long double Quadratic::discriminant() const { return square(b_) - a_ * c_; })");
    const auto result = check("02", root);
    INFO(result.output << result.errors);
    CHECK(result.code == 0);
}

TEST_CASE("a function that replaces one of the lab's own is refused by name") {
    const auto result = check(
        "02", sphere_answer("replaces", "    return std::nullopt;", "int main() { std::puts(\"PASSED\"); return 0; }"));
    INFO(result.output);
    CHECK(result.code == 1);
    CHECK(says(result, "the file defines main, which the lab defines itself: choose another name"));
}

TEST_CASE("a function of the library is refused by name") {
    const auto result =
        check("02", sphere_answer("asks_the_library", "    return sphere_root(ray, sphere);",
                                  "namespace raylab { std::optional<double> sphere_root(const RayOf<double>&, const "
                                  "SphereOf<double>&); }"));
    INFO(result.output);
    CHECK(result.code == 1);
    CHECK(says(result, "the file calls raylab::sphere_root("));
}

TEST_CASE("a chart is drawn of an answer that passes, and of no other: its few questions would praise a wrong one") {
    const auto chart = [](const fs::path& answer) {
        return says(check("02", answer, {"--out", (answers / "drawn").string()}), "Chart (`yours`");
    };
    CHECK_FALSE(chart(RAYLAB_SOURCE "/exercises/02_ray_sphere/mistakes/far_root.cpp"));
    CHECK(chart(RAYLAB_SOURCE "/exercises/02_ray_sphere/right/geometric.cpp"));
}

TEST_CASE("a function that fails only while the picture is drawn is told so, with the place and the way") {
    auto text = raylab::read_file(RAYLAB_SOURCE "/exercises/02_ray_sphere/right/geometric.cpp");
    text.insert(text.find("    const Vec3d to_center"),
                "    static int asked = 0;\n    if (++asked > 2000) __builtin_trap();\n");
    raylab::write_file(answers / "fails_late.cpp", text);
    const auto result = check("02", answers / "fails_late.cpp", {"--out", (answers / "drawn").string()});
    INFO(result.output << result.errors);
    CHECK(says(result, "PASSED"));
    CHECK(says(result, "No whole picture: from pixel ("));
    CHECK(says(result, "the function did not return: killed by signal"));
}

TEST_CASE("a helper that is declared and never written is none of the library's") {
    const auto result = check("02", sphere_answer("never_written", "    return helper(sphere.radius);",
                                                  "namespace raylab { double helper(double); }"));
    INFO(result.output);
    CHECK(says(result, "the file calls raylab::helper(double), which nothing defines"));
    CHECK_FALSE(says(result, "a function of the library:"));
}

TEST_CASE("a function that is defined outside of the namespace is told so") {
    raylab::write_file(answers / "outside.cpp",
                       "#include \"raylab/geometry/nearest_sphere_hit.h\"\nusing namespace raylab;\n"
                       "std::optional<double> nearest_sphere_hit(const RayOf<double>&, const SphereOf<double>&) {\n"
                       "    return 1;\n}\n");
    const auto result = check("02", answers / "outside.cpp");
    INFO(result.output);
    CHECK(says(result, "but ::nearest_sphere_hit("));
    CHECK(says(result, "outside of namespace raylab"));
}

TEST_CASE("how a function ends is told in words that lead to the line") {
    const auto told = [](const std::string& name, const std::string& body, const std::string& before,
                         const std::vector<std::string>& words) {
        const auto result = check("02", sphere_answer(name, body, before));
        INFO(result.output << result.errors);
        CHECK(result.code == 1);
        for (const auto& each : words) CHECK(says(result, each));
        CHECK_FALSE(says(result, "exit code 4"));
    };
    told("throws", "    return std::vector<double>{}.at(3);", "#include <vector>",
         {"the function did not return: it threw an exception: vector::_M_range_check"});
    told("throws_a_number", "    throw 5;", "", {"it threw an exception: one that is no std::exception"});
    told("null", "    const volatile double* none = nullptr;\n    return *none;", "",
         {"killed by signal 11", "it read or wrote memory that is not its own: an index beyond the end"});
    told("without_end", "    return sphere.radius < 0 ? 1 : *nearest_sphere_hit(ray, sphere) + 1;", "",
         {"a function that calls itself without end"});
    told("beyond_the_end", "    const std::vector<double> two(2);\n    return two[asked() + 2];",
         "#include <vector>\nstatic std::size_t asked() { static volatile std::size_t zero = 0; return zero; }",
         {"Assertion '__n < this->size()' failed"});
    told("nothing_in_it", "    std::optional<double> none;\n    return *none;", "",
         {"Assertion", "_M_is_engaged()", "(Aborted): an assertion failed, which it printed, or abort() was called"});
}

TEST_CASE("an answer that is no number is shown as that, with the hint for it, where it is the first wrong one") {
    const auto result = check("02",
                              sphere_answer("no_number",
                                            "    static_cast<void>(sphere);\n"
                                            "    return ray.origin.x < 0 ? std::sqrt(-1.0) : std::optional(1.0);",
                                            "#include <cmath>"),
                              {"--verdict-only", "--seed", "3"});
    INFO(result.output);
    CHECK(says(result, "got        t = not a number"));
    CHECK(says(result, "Your answer is no number there."));
}

TEST_CASE("a question about a node that is none is told as that") {
    const auto asks = [](const std::string& name, const std::string& question) {
        const auto file = answers / (name + ".cpp");
        raylab::write_file(file, "#include \"raylab/accelerator/bvh/nearest_in_tree.h\"\n"
                                 "std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) {\n"
                                 "    return tree." +
                                     question + ";\n}\n");
        return check("09b", file);
    };
    for (const auto* node : {"-1", "103", "20000"}) {
        const auto box = asks("asks_for_no_box", "entry(" + std::string(node) + ")");
        INFO(node << "\n" << box.output);
        CHECK(says(box, "by 1 question: the box of a node that does not exist"));
        CHECK(says(asks("asks_for_no_things", "hit(" + std::string(node) + ")"),
                   "the things of a node that does not exist"));
    }
    CHECK(says(asks("asks_the_root", "hit(0)"), "the things of node 0, which is no leaf"));
}

TEST_CASE("an answer with every case right and too much work does not pass") {
    const auto result = check("10", RAYLAB_SOURCE "/exercises/10_grid_step/mistakes/a_billionth_on.cpp");
    INFO(result.output << result.errors);
    CHECK(result.code == 1);
    CHECK(says(result, "✓  rays from a corner"));
    CHECK(says(result, "stopped at 10 times the reference's questions"));
    CHECK(says(result, "no point has to be looked up"));
    CHECK(says(result, "400 of 400 graded cases right, 2 of 3 counts of work"));
}

TEST_CASE("a crash while work is counted does not hide that answers are wrong, and is told beside them") {
    const auto file = answers / "stays_and_dies.cpp";
    raylab::write_file(file, "#include \"raylab/accelerator/grid/next_cell.h\"\n#include "
                             "<cstdlib>\nstd::optional<raylab::Cell> raylab::next_cell(const RayOf<double>&, const "
                             "UniformGrid&, const Cell& cell) {\n    static int asked = 0;\n    if (++asked > 1000) "
                             "std::abort();\n    return cell;\n}\n");
    const auto result = check("10", file);
    INFO(result.output << result.errors);
    CHECK(result.code == 1);
    CHECK(says(result, "The first wrong answer"));
    CHECK(says(result, "not counted: the function did not come to an end, killed by signal"));
}

TEST_CASE("a crash, an early exit, a flood and an endless loop are told as what they are") {
    const auto crash = check("02", sphere_answer("crash", "    std::abort();"));
    CHECK(crash.code == 1);
    CHECK(says(crash, "signal"));
    const auto leaves = check("02", sphere_answer("leaves", "    std::exit(0);"));
    CHECK(leaves.code == 1);
    CHECK(says(leaves, "before all cases were answered"));
    const auto prints = check("02", sphere_answer("prints", "    std::puts(\"PASSED 1 of 1\"); std::fflush(stdout); "
                                                            "return std::nullopt;"));
    CHECK(prints.code == 1);
    const auto loops = check("02", sphere_answer("loops", "    for (volatile int i = 0;; i = i + 1) {}"));
    CHECK(loops.code == 1);
    CHECK(says(loops, "takes too long"));
}

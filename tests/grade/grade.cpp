#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/read_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

// `raylab grade` from outside, as a course's machine runs it.

namespace fs = std::filesystem;
using raylab::ProcessResult;
using raylab::write_file;

namespace {

const fs::path folder = fs::path(RAYLAB_BUILD) / "tests/grade_files";
const std::string exercise_02 = RAYLAB_SOURCE "/exercises/02_ray_sphere/";

ProcessResult grade(const fs::path& submission, const std::vector<std::string>& more = {},
                    const std::string& exercise = "02") {
    std::vector<std::string> words{"grade", exercise, "--submission", submission.string(), "--format", "json"};
    words.insert(words.end(), more.begin(), more.end());
    return raylab::run_process(RAYLAB_BUILD "/raylab", words, {.folder = folder, .timeout = 120});
}

nlohmann::ordered_json result_of(const ProcessResult& process) {
    INFO(process.output << process.errors);
    REQUIRE(!process.output.empty());
    return raylab::json_from_text(process.output, "the result");
}

std::string verdict(const ProcessResult& process) { return result_of(process)["verdict"]; }

fs::path file(const std::string& name, const std::string& text) {
    write_file(folder / name, text);
    return folder / name;
}

nlohmann::ordered_json without_times(const ProcessResult& process) {
    auto json = result_of(process);
    json.erase("times");
    return json;
}

}  // namespace

TEST_CASE("an answer that passes has all points; the same seed gives the same result, no seed a new one") {
    fs::create_directories(folder);
    const auto passed = grade(exercise_02 + "right/geometric.cpp", {"--seed", "7", "--points", "10"});
    CHECK(passed.code == 0);
    const auto result = result_of(passed);
    CHECK(result["verdict"] == "pass");
    CHECK(result["score"] == 10.0);
    CHECK(result["seed"] == 7);
    CHECK(result["isolation"]["level"] >= 2);
    CHECK(result["submission"]["sha256"].get<std::string>().size() == 64);

    const fs::path wrong = exercise_02 + "mistakes/far_root.cpp";
    const auto first = grade(wrong, {"--seed", "7"});
    CHECK(first.code == 1);
    CHECK(without_times(first) == without_times(grade(wrong, {"--seed", "7"})));
    CHECK(result_of(first)["seed"] != result_of(grade(wrong))["seed"]);
    CHECK(result_of(first)["hint_id"] != "");
    const auto lower = result_of(grade(wrong, {"--seed", "7", "--isolation", "2"}));
    CHECK(lower["isolation"]["level"] == 2);
    CHECK(lower["score"] == result_of(first)["score"]);
    CHECK(result_of(first)["score"] < 100.0);
    CHECK(result_of(first)["score"] > 0.0);
}

TEST_CASE("a hint that is for every exercise has its text in the result, too") {
    fs::create_directories(folder);
    const auto result = result_of(grade(RAYLAB_SOURCE "/exercises/14_contour/mistakes/over_four_pi.cpp", {}, "14"));
    CHECK(result["hint_id"] == "factor");
    CHECK(result["hint"].get<std::string>().find("a fixed multiple") != std::string::npos);
}

TEST_CASE("seeds by a key differ between students and are the same again") {
    const auto key = file("course.key", "sixteen bytes and more");
    const fs::path stub = exercise_02 + "nearest_sphere_hit.cpp";
    const auto of = [&](const std::string& student) {
        return result_of(grade(stub, {"--key", key.string(), "--student", student}))["seed"].get<std::uint64_t>();
    };
    CHECK(of("one") == of("one"));
    CHECK(of("one") != of("other"));
}

TEST_CASE("what cannot be graded as it is has a clear verdict each, and no points") {
    const auto no_submission = [](const fs::path& submission, const std::string& reason) {
        const auto process = grade(submission);
        const auto result = result_of(process);
        INFO(submission.string() << "\n" << process.output);
        CHECK(process.code == 1);
        CHECK(result["verdict"] == "no_submission");
        CHECK(result["summary"].get<std::string>().find(reason) != std::string::npos);
        CHECK(result["score"] == 0.0);
        CHECK(!result["tests"].empty());
    };
    no_submission(folder / "missing.cpp", "there is no file missing.cpp");
    no_submission(file("empty.cpp", " \n\t"), "the file is empty");
    no_submission(file("binary.cpp", std::string("\x7f"
                                                 "ELF\0\0",
                                                 6)),
                  "no text");
    no_submission(file("large.cpp", std::string(10 << 20, '/')), "has 10.0 MB");
    // A ZIP whose one entry is named ../../escaped.
    no_submission(file("answer.zip", std::string("PK\x03\x04\x14\0\0\0\0\0", 10) + "../../escaped"), "a ZIP archive");
    no_submission(file("utf16.cpp", std::string("\xff\xfe"
                                                "d\0",
                                                4)),
                  "UTF-16");
    no_submission("/dev/null", "no regular file");
    CHECK(!fs::exists(folder.parent_path().parent_path() / "escaped"));

    const auto many = folder / "two";
    file("two/a/nearest_sphere_hit.cpp", "x");
    file("two/b/nearest_sphere_hit.cpp", "x");
    no_submission(many, "there are 2 files nearest_sphere_hit.cpp: a/");
    file("none/report.pdf", "x");
    no_submission(folder / "none", "expected a file nearest_sphere_hit.cpp, found report.pdf");
    file("capitals/Nearest_Sphere_Hit.cpp", "x");
    file("capitals/old.cpp", "x");
    no_submission(folder / "capitals", "expected a file nearest_sphere_hit.cpp, found Nearest_Sphere_Hit.cpp, old.cpp; "
                                       "small letters and capitals differ");
    fs::remove_all(folder / "linked");
    fs::create_directories(folder / "linked");
    fs::create_symlink(exercise_02 + "right/geometric.cpp", folder / "linked/nearest_sphere_hit.cpp");
    no_submission(folder / "linked", "expected a file nearest_sphere_hit.cpp, found no file; not followed, since it is "
                                     "a link: nearest_sphere_hit.cpp");
}

TEST_CASE("of a folder the exercise's file is taken; links are not followed, and what is ignored is told") {
    const auto handed_in = folder / "handed_in";
    fs::remove_all(handed_in);
    fs::create_directories(handed_in / "code");
    fs::copy_file(exercise_02 + "right/geometric.cpp", handed_in / "code/nearest_sphere_hit.cpp");
    file("handed_in/CMakeLists.txt", "file(REMOVE_RECURSE /)");
    fs::create_symlink("/", handed_in / "everything");
    fs::create_symlink(handed_in / "code/nearest_sphere_hit.cpp", handed_in / "nearest_sphere_hit.cpp");
    const auto result = result_of(grade(handed_in));
    CHECK(result["verdict"] == "pass");
    CHECK(result["submission"]["notes"][0] == "ignored: CMakeLists.txt");
}

TEST_CASE("a link that is handed in is not followed, and what it leads to is not told") {
    fs::create_directories(folder);
    const auto secret = file("secret.txt", "the course's secret\n");
    const auto link_to = [](const fs::path& target) {
        const auto link = folder / "link.cpp";
        fs::remove(link);
        fs::create_symlink(target, link);
        return link;
    };
    const auto handed_in = folder / "of_a_student";
    fs::create_directories(handed_in);
    fs::copy_file(exercise_02 + "right/geometric.cpp", handed_in / "nearest_sphere_hit.cpp",
                  fs::copy_options::overwrite_existing);
    for (const auto& target : {secret, fs::path(exercise_02 + "right/geometric.cpp"), handed_in, folder / "missing"}) {
        const auto process = grade(link_to(target));
        INFO(target << "\n" << process.output << process.errors);
        CHECK(verdict(process) == "no_submission");
        CHECK(result_of(process)["score"] == 0.0);
        CHECK(process.output.find("is a symbolic link") != std::string::npos);
        CHECK(process.output.find("the course's secret") == std::string::npos);
    }
    // Not even to see whether the result would replace what was handed in.
    const auto result = folder / "result.json";
    for (const auto& target : {folder, result}) {
        const auto process = grade(link_to(target), {"-o", result.string()});
        INFO(target << "\n" << process.output << process.errors);
        CHECK(process.code == 1);
        CHECK(raylab::read_json(result)["verdict"] == "no_submission");
    }
    // Where the folders above it lead is nothing that a student decides.
    const auto above = folder / "above";
    fs::remove(above);
    fs::create_directory_symlink(handed_in, above);
    CHECK(verdict(grade(above / "nearest_sphere_hit.cpp")) == "pass");
}

TEST_CASE("what does not compile, is refused or ends badly keeps its verdict, and points for what was right before") {
    CHECK(verdict(grade(exercise_02 + "nearest_sphere_hit.cpp")) == "unfinished");
    const auto broken = grade(file("broken.cpp", "this is no C++"));
    CHECK(verdict(broken) == "does_not_compile");
    CHECK(
        result_of(broken)["build"]["diagnostics"].get<std::string>().starts_with("nearest_sphere_hit.cpp:1:1: error"));
    CHECK(verdict(grade(file("refused.cpp", "#include \"/etc/passwd\"\n"))) == "refused");

    auto crashing = raylab::read_file(exercise_02 + "right/geometric.cpp");
    crashing.insert(crashing.rfind("{", crashing.find("sqrt")) + 1,
                    "\n    static int asked = 0;\n    if (++asked > 150) __builtin_trap();\n");
    const auto result = result_of(grade(file("crashing.cpp", crashing), {"--seed", "1"}));
    CHECK(result["verdict"] == "crash");
    CHECK(result["score"] > 0.0);
    CHECK(result["score"] < 100.0);
}

TEST_CASE("one answer for all cases has no points, even where it is right for a whole part") {
    const auto result = result_of(grade(file("guess.cpp", "#include \"raylab/geometry/nearest_sphere_hit.h\"\n"
                                                          "std::optional<double> raylab::nearest_sphere_hit("
                                                          "const RayOf<double>&, const SphereOf<double>&) {\n"
                                                          "    return std::nullopt;\n}\n")));
    CHECK(result["verdict"] == "wrong");
    CHECK(result["score"] == 0.0);
    CHECK(std::ranges::any_of(result["tests"], [](const auto& part) { return part["verdict"] == "pass"; }));
}

TEST_CASE("an internal result is written first, and where the grader cannot grade") {
    const auto to_file = [](const std::vector<std::string>& more, const std::string& exercise = "02") {
        auto words = more;
        const auto output = folder / "internal.json";
        fs::remove(output);
        words.insert(words.end(), {"-o", output.string()});
        const auto process = grade(exercise_02 + "right/geometric.cpp", words, exercise);
        CHECK(process.code == 2);
        return raylab::read_json(output);
    };
    const auto no_exercise = to_file({}, "99");
    CHECK(no_exercise["verdict"] == "internal");
    CHECK(no_exercise["summary"].get<std::string>().find("expected an exercise") != std::string::npos);
    CHECK(to_file({"--key", (folder / "no.key").string()})["verdict"] == "internal");
    CHECK(to_file({"--key", file("short.key", "short").string()})["verdict"] == "internal");
    const auto low = to_file({"--isolation", "1"});
    CHECK(low["verdict"] == "internal");
    CHECK(low["score"] == 0.0);

    const auto killed = folder / "killed.json";
    write_file(killed, "a result of another time");
    // What a machine out of memory does.
    raylab::run_process(
        "sh", {"-c", "\"$0\" grade 02 --submission \"$1\" --format json -o \"$2\" & sleep 0.2; kill -9 $!; wait",
               RAYLAB_BUILD "/raylab", exercise_02 + "right/geometric.cpp", killed.string()});
    CHECK(raylab::read_json(killed)["verdict"] == "internal");
}

#include "catch.h"

#include "exercise.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/read_json.h"

#include <unistd.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// What a course gives out checks alone, and tells nobody the answer.

namespace fs = std::filesystem;
using namespace raylab;

namespace {

const fs::path made = fs::path(RAYLAB_BUILD) / "tests/handout";
const std::string exercise_02 = RAYLAB_SOURCE "/exercises/02_ray_sphere/";

bool is_root() { return geteuid() == 0; }

// Runs a command where the project is not: root can hide it. Elsewhere the test says less.
ProcessResult run_alone(const std::string& command) {
    const std::string hidden = is_root() ? "mount -t tmpfs none " RAYLAB_SOURCE " && " : "";
    const std::vector<std::string> shell{"sh", "-c", hidden + command};
    if (!is_root()) return run_process("sh", {"-c", command}, {.folder = "/", .timeout = 240});
    std::vector<std::string> words{"-m"};
    words.insert(words.end(), shell.begin(), shell.end());
    return run_process("unshare", words, {.folder = "/", .timeout = 240});
}

// Lines of code that say something: no other file has them by chance.
std::set<std::string> telling_lines(const fs::path& source) {
    constexpr std::size_t telling = 45;  // characters
    std::set<std::string> lines;
    std::istringstream text(read_file(source));
    for (std::string line; std::getline(text, line);) {
        line.erase(0, line.find_first_not_of(' '));
        const bool is_code = line.find(';') != line.npos && !line.starts_with("//") && !line.starts_with("#");
        if (is_code && line.size() >= telling) lines.insert(line);
    }
    return lines;
}

std::string all_texts(const fs::path& folder) {
    std::string all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().string().find("/build/") == std::string::npos)
            all += read_file(entry.path());
    return all;
}

// What a pattern's group finds in a lesson.
struct Named {
    fs::path lesson;
    std::string name;
};

std::vector<Named> named_in(const fs::path& lessons, const std::regex& pattern) {
    std::vector<Named> names;
    for (const auto& entry : fs::recursive_directory_iterator(lessons)) {
        if (entry.path().extension() != ".md") continue;
        const auto text = read_file(entry.path());
        for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
            names.push_back({entry.path(), (*match)[1]});
    }
    return names;
}

// The scenes of the lab's own that the lessons' commands name, as they name them.
std::set<std::string> scenes_named_in(const fs::path& lessons) {
    static const std::regex scene(R"(\./raylab [^\n`]*?(chapters/[a-z0-9_/]+\.toml))");
    std::set<std::string> names;
    for (const auto& [lesson, name] : named_in(lessons, scene)) names.insert(name);
    REQUIRE(names.size() > 12);
    return names;
}

// The links of texts to files that are not there.
std::set<std::string> dead_links(const fs::path& texts) {
    static const std::regex link(R"(\]\(((?!http|#)[^) #]*[./][^) #]*)[^)\n]*\))");
    std::set<std::string> dead;
    for (const auto& [lesson, name] : named_in(texts, link))
        if (!fs::exists(lesson.parent_path() / name))
            dead.insert(lesson.lexically_relative(texts).string() + ": " + name);
    return dead;
}

nlohmann::ordered_json json_in(const fs::path& file) { return read_json(file); }

}  // namespace

TEST_CASE("a handout checks alone, wherever it stands, and holds no reference and no mistake") {
    fs::remove_all(made);
    const auto written = run_process(RAYLAB_BUILD "/raylab", {"handout", made.string()}, {.timeout = 240});
    INFO(written.output << written.errors);
    REQUIRE(written.succeeded());
    const fs::path moved = fs::temp_directory_path() / ("raylab_handout_" + std::to_string(getpid()));
    fs::remove_all(moved);
    fs::copy(made, moved, fs::copy_options::recursive);

    for (const auto& entry : fs::recursive_directory_iterator(moved)) {
        const auto name = entry.path().filename().string();
        CHECK(name != "mistakes");
        CHECK(name != "right");
        CHECK(name != "slot");
        CHECK(name != "judge.cpp");
    }
    for (const auto& entry : fs::recursive_directory_iterator(moved / "exercises"))
        if (entry.path().filename() == "quiz.toml") {
            INFO(entry.path());
            const auto quiz = read_file(entry.path());
            CHECK(quiz.find("\nnumber = ") == std::string::npos);
            CHECK(quiz.find("\nright = ") == std::string::npos);
        }
    for (const auto& exercise : grading::exercises()) {
        INFO(exercise.folder);
        const auto hints = read_file(moved / "exercises" / exercise.folder / "hints.toml");
        CHECK(hints.find("/slot/") == std::string::npos);
        CHECK(hints.find("\nlook = ") != std::string::npos);
    }
    const auto texts = all_texts(moved);
    for (const auto& exercise : grading::exercises())
        for (const auto& entry : fs::recursive_directory_iterator(RAYLAB_SOURCE "/lib"))
            if (entry.path().filename() == exercise.slot + ".cpp")
                for (const auto& line : telling_lines(entry.path())) {
                    INFO(exercise.folder << ": " << line);
                    CHECK(texts.find(line) == std::string::npos);
                }
    const auto program = read_file(moved / "build/release/raylab");
    CHECK(program.find("nearest_sphere_hit_far_root") == std::string::npos);

    fs::copy_file(exercise_02 + "right/geometric.cpp", moved / "right.cpp");
    fs::copy_file(RAYLAB_SOURCE "/exercises/05_phong_specular/right/by_products.cpp", moved / "phong.cpp");
    fs::copy_file(exercise_02 + "mistakes/far_root.cpp", moved / "wrong.cpp");
    const auto here = "cd " + moved.string() + " && ";
    const auto checked = [&](const std::string& words) { return run_alone(here + "./raylab check " + words); };
    const auto stub = checked("02 --verdict-only");
    INFO(stub.output << stub.errors);
    CHECK(stub.output.find("not written yet") != std::string::npos);
    const auto right = checked("02 --answer right.cpp");  // with its picture
    INFO(right.output << right.errors);
    CHECK(right.code == 0);
    CHECK(right.output.find("No chart: this is a handout") != std::string::npos);
    CHECK(right.output.find("A look at the reference:\n") != std::string::npos);
    const auto wrong = checked("02 --verdict-only --answer wrong.cpp");
    CHECK(wrong.code == 1);
    CHECK(wrong.output.find("Your t is where the ray leaves the sphere") != std::string::npos);
    const auto quiz = run_alone(here + "printf '1\n3\n1\n' | ./raylab check 02 --quiz");
    INFO(quiz.output << quiz.errors);
    CHECK(quiz.output.find("2 of 3 right") != std::string::npos);
    CHECK(quiz.output.find("95 million radii.") == std::string::npos);
    CHECK(dead_links(moved / "chapters") == std::set<std::string>{});
    for (const auto& scene : scenes_named_in(moved / "chapters")) {
        const auto read = run_alone(here + "./raylab needs " + scene);
        INFO(scene << "\n" << read.output << read.errors);
        CHECK(read.succeeded());
    }
    const auto chapter = run_alone(here + "./raylab chapter 02");
    INFO(chapter.errors);
    CHECK(chapter.errors.find(
              "this is a handout, without the chapters' programs: chapters/02_spheres_and_quadrics/README.md is "
              "the lesson") != std::string::npos);
    const auto work = run_alone(here + "./raylab check 10 --verdict-only");  // one with shared libraries
    INFO(work.output << work.errors);
    CHECK(work.output.find("not written yet") != std::string::npos);

    const auto own = moved / "exercises/02_ray_sphere/nearest_sphere_hit.cpp";
    fs::copy_file(moved / "right.cpp", own, fs::copy_options::overwrite_existing);
    const auto watched = run_alone(here + "./raylab watch 02 --once");
    INFO(watched.output << watched.errors);
    CHECK(watched.code == 0);
    CHECK(watched.output.find("Exercise 02_ray_sphere: exercises/02_ray_sphere/nearest_sphere_hit.cpp:1\n") !=
          std::string::npos);
    fs::remove_all(moved);
}

TEST_CASE("each package grades as its machine calls it, and says so where it cannot") {
    const fs::path folder = fs::path(RAYLAB_BUILD) / "tests/packages";
    fs::remove_all(folder);
    const auto package = [&](const std::string& kind) {
        return run_process(RAYLAB_BUILD "/raylab", {"package", "02", "--for", kind, "-o", (folder / kind).string()},
                           {.timeout = 120});
    };
    for (const auto* kind : {"gradescope", "github", "prairielearn"}) CHECK(package(kind).succeeded());
    CHECK(package("gradesope").code == 2);

    const auto autograder = folder / "autograder", grade = folder / "grade";
    for (const auto& at : {autograder / "results", autograder / "submission", grade / "student"})
        fs::create_directories(at);
    fs::rename(folder / "gradescope", autograder / "source");
    fs::copy_file(exercise_02 + "mistakes/far_root.cpp", autograder / "submission/nearest_sphere_hit.cpp");
    fs::copy_file(exercise_02 + "right/geometric.cpp", grade / "student/nearest_sphere_hit.cpp");
    const auto script = "AUTOGRADER=" + autograder.string() + " " + (autograder / "source/run_autograder").string();
    CHECK(run_process("sh", {"-c", script}, {.timeout = 120}).succeeded());
    const auto results = autograder / "results/results.json";
    CHECK(json_in(results)["extra_data"]["verdict"] == "wrong");
    fs::remove(autograder / "source/lab/raylab");
    CHECK(run_process("sh", {"-c", script}, {.timeout = 120}).succeeded());
    CHECK(json_in(results)["extra_data"]["verdict"] == "internal");

    const auto lab = folder / "prairielearn/lab";
    CHECK(run_process("sh",
                      {"-c", "GRADE=" + grade.string() + " LAB=" + lab.string() + " " +
                                 (folder / "prairielearn/entrypoint.sh").string()},
                      {.timeout = 120})
              .succeeded());
    CHECK(json_in(grade / "results/results.json")["score"] == 1.0);

    const auto output = folder / "github_output";
    fs::copy_file(exercise_02 + "right/geometric.cpp", folder / "github/nearest_sphere_hit.cpp");
    CHECK(run_process("sh", {"-c", "GITHUB_OUTPUT=" + output.string() + " " + (folder / "github/grade.sh").string()},
                      {.timeout = 120})
              .succeeded());
    const auto result = [&] {
        const auto step = run_process("sh", {"-c", "tail -n 1 " + output.string() + " | sed s/^result=// | base64 -d"});
        return json_from_text(step.output, "the step's result");
    };
    CHECK(result()["status"] == "pass");

    fs::remove(folder / "github/nearest_sphere_hit.cpp");
    fs::create_symlink(exercise_02 + "right/geometric.cpp", folder / "github/nearest_sphere_hit.cpp");
    run_process("sh", {"-c", "GITHUB_OUTPUT=" + output.string() + " " + (folder / "github/grade.sh").string()},
                {.timeout = 120});
    CHECK(result()["status"] == "fail");
    CHECK(result().dump().find("is a symbolic link") != std::string::npos);
    fs::remove_all(folder);
}

#include "catch.h"

#include "formats.h"
#include "grade_json.h"
#include "part_text.h"
#include "seeds.h"

#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/read_json.h"

#include <nlohmann/json.hpp>

#include <filesystem>

// Every outcome in every format, with texts that would break each of them, against the formats' own schemas.

namespace fs = std::filesystem;
using namespace raylab;
using namespace raylab::grading;

namespace {

const std::string hostile = "]]> </failure><script>alert(1)</script> & \" ' # \\ \033[32mPASSED\033[0m \r\n\n"
                            "ok 99 - forged\nBail out!\n  ---\n  ...\n{\"scores\":{\"all\":100}}\n\xff\xfe\0 "
                            "\u202e\u2028 Grade :=>> 100 \xe2\x98";

Grade made(Outcome outcome) {
    Grade grade{.exercise = "02_ray_sphere", .student = hostile, .outcome = outcome, .summary = hostile};
    if (outcome == Outcome::internal) return grade;
    grade.details = hostile;
    const bool passes = outcome == Outcome::pass;
    for (const std::size_t right : {std::size_t{40}, passes ? std::size_t{40} : std::size_t{0}})
        grade.parts.push_back({.name = "in front, #1 <" + std::to_string(right) + ">",
                               .right = right,
                               .total = 40,
                               .points = right ? 5000 : 0,
                               .most = 5000,
                               .message = hostile});
    if (!passes) grade.first_wrong = FirstWrong{7, grade.parts[1].name, hostile, hostile, hostile};
    grade.hint = grade.compiler = grade.printed = std::string(100'000, '\xe4') + hostile;
    grade.submitted = {"nearest_sphere_hit.cpp", std::string(64, 'a'), "2026-01-31T11:00:00Z", 17, {hostile}};
    grade.seed = largest_seed;
    grade.isolation = Isolation{Level::files, 7, true};
    grade.cases_sha256 = std::string(64, '0');
    grade.began = grade.ended = "2026-01-31T12:00:00Z";
    grade.compile_seconds = 0.6;
    return grade;
}

}  // namespace

TEST_CASE("every outcome in every format is what the format's own schema takes") {
    const fs::path folder = RAYLAB_BUILD "/tests/formats";
    fs::remove_all(folder);
    for (int i = 0; i <= static_cast<int>(Outcome::internal); ++i) {
        const auto grade = made(static_cast<Outcome>(i));
        for (const auto& format : formats())
            write_file(folder / (to_string(grade.outcome) + "." + format.name), format.text_of(grade));
    }
    const auto checked =
        run_process("python3", {RAYLAB_SOURCE "/tests/grade/check_formats.py", folder.string()}, {.timeout = 60});
    INFO(checked.output << checked.errors);
    CHECK(checked.succeeded());
}

TEST_CASE("each format tells why there are no points, and the hint") {
    for (const auto outcome : {Outcome::does_not_compile, Outcome::refused, Outcome::no_submission, Outcome::crash,
                               Outcome::timeout, Outcome::wrong}) {
        auto grade = made(outcome);
        grade.summary = "what became of it";
        grade.compiler = "words of the compiler";
        grade.details = "how it ended in short";
        grade.hint = "a hint to follow";
        for (auto& part : grade.parts) part.message = "0 of 40 cases right";
        for (const auto& format : formats()) {
            const auto text = format.text_of(grade);
            INFO(to_string(outcome) << ", " << format.name << "\n" << text);
            for (const auto& words : {grade.summary, grade.compiler, grade.details, grade.hint})
                CHECK(text.find(words) != std::string::npos);
        }
    }
}

TEST_CASE("a result is read again as it was written") {
    for (int i = 0; i <= static_cast<int>(Outcome::internal); ++i) {
        const auto text = as_json(made(static_cast<Outcome>(i)));
        CHECK(as_json(grade_from_json(json_from_text(text, "a result"), "a result")) == text);
    }
    CHECK_THROWS_AS(grade_from_json(json_from_text("{}", "nothing"), "nothing"), Error);
}

TEST_CASE("what is no result is an Error that names the file, the place, what was expected and what was found") {
    const auto refused = [](const char* key, const nlohmann::ordered_json& value, const std::string& words) {
        auto json = to_json(made(Outcome::wrong));
        json[key] = value;
        CHECK_THROWS_WITH(grade_from_json(json, "results/one.json"), Catch::Contains("results/one.json " + words));
    };
    refused("format", "raylab.result/9", "/format: expected raylab.result/1, found raylab.result/9");
    refused("verdict", "maybe",
            "/verdict: expected one of pass, wrong, nonfinite, too_much_work, unfinished, "
            "incomplete, crash, timeout, memory, output_limit, policy, does_not_compile, refused, "
            "no_submission, internal, found maybe");
}

TEST_CASE("text is cut between two characters, and never longer than asked for") {
    for (std::size_t longest = 3; longest < 20; ++longest) {
        const auto text = safe_text("äöüßäöüßäöüß", longest);
        CHECK(text.size() <= longest);
        CHECK(text == safe_text(text, longest));
    }
}

TEST_CASE("points are exact to the hundredth and never more than there are") {
    Grade grade{.most = 10000};
    for (int i = 0; i < 3; ++i)
        grade.parts.push_back({.name = "a third", .points = 3333 + (i == 2), .most = 3333 + (i == 2)});
    CHECK(points_text(grade.points()) == "100");
    grade.parts.push_back({.name = "too much", .points = 2, .most = 1});
    CHECK(points_text(grade.points()) == "100");
    CHECK(points_text(3333) == "33.33");
}

TEST_CASE("a total depends on how many equal parts are passed, not on which") {
    const auto total = [](std::size_t count, std::size_t passed, std::size_t first) {
        Grade grade{.exercise = "02_ray_sphere", .outcome = Outcome::wrong};
        for (std::size_t i = 0; i < count; ++i) {
            const bool right = (i + count - first) % count < passed;
            grade.parts.push_back({.name = "a part", .right = right ? 1u : 0u, .total = 1});
        }
        grade.parts = with_equal_points(std::move(grade.parts), grade.most);
        return grade;
    };
    for (std::size_t first = 0; first < 15; ++first) {
        CHECK(points_text(total(15, 6, first).points()) == "40");
        CHECK(points_text(total(15, 14, first).points()) == "93.33");
        CHECK(points_text(total(15, 15, first).points()) == "100");
    }
    for (const std::size_t first : {0u, 7u}) {
        const auto read = grade_from_json(json_from_text(as_json(total(15, 6, first)), "a result"), "a result");
        CHECK(points_text(read.points()) == "40");
        CHECK(as_prairielearn(total(15, 6, first)).find("\"score\": 0.4,") != std::string::npos);
    }
}

TEST_CASE("an internal result gives no points and takes none") {
    const Grade internal{.exercise = "02_ray_sphere"};
    CHECK(as_autolab(internal).find(R"("scores":{})") != std::string::npos);
    CHECK(as_prairielearn(internal).find(R"("gradable": false)") != std::string::npos);
    CHECK(as_tap(internal).find("Bail out!") != std::string::npos);
    CHECK(as_junit(internal).find("<error") != std::string::npos);
    CHECK(as_github(internal).find(R"("status": "error")") != std::string::npos);
}

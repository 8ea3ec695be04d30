#include "catch.h"
#include "could_not.h"
#include "says.h"

#include "class_table.h"
#include "formats.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/read_json.h"

#include <nlohmann/json.hpp>

#include <sys/stat.h>

#include <filesystem>
#include <iterator>
#include <map>
#include <string>

// A class: by hand, where nothing has to be compiled, and from outside.

namespace fs = std::filesystem;
using namespace raylab;
using namespace raylab::grading;

namespace {

const fs::path class_folder = fs::path(RAYLAB_BUILD) / "tests/class";
const std::string spheres = RAYLAB_SOURCE "/exercises/02_ray_sphere/";

Grade made(const std::string& student, const std::string& exercise, Hundredths points, Outcome outcome,
           const std::string& hint = {}, const std::string& fingerprint = {}) {
    Grade grade{.exercise = exercise, .student = student, .outcome = outcome};
    grade.parts = {{.name = "all", .right = points == 10000 ? 1u : 0u, .total = 1, .points = points, .most = 10000}};
    grade.hint_id = hint;
    grade.fingerprint = fingerprint;
    grade.submitted.modified = "2026-01-31T12:00:00Z";
    return grade;
}

Course course_of(const std::string& text) {
    const auto file = class_folder / "course_trial.toml";
    write_file(file, text);
    return read_course(file);
}

ProcessResult run_class(const std::vector<std::string>& more) {
    std::vector<std::string> words{"grade"};
    words.insert(words.end(), more.begin(), more.end());
    return run_process(RAYLAB_BUILD "/raylab", words, {.folder = class_folder, .timeout = 240});
}

void hand_in(const std::string& student, const std::string& answer) {
    fs::create_directories(class_folder / "class" / student);
    fs::copy_file(spheres + answer, class_folder / "class" / student / "nearest_sphere_hit.cpp",
                  fs::copy_options::overwrite_existing);
}

// The results without what no two runs share.
std::map<std::string, std::string> results(const fs::path& report) {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(class_folder / report / "results")) {
        if (!entry.is_regular_file()) continue;
        auto json = read_json(entry.path());
        json.erase("times");
        all[entry.path().filename().string()] = json.dump();
    }
    return all;
}

}  // namespace

TEST_CASE("a total is the mean by weights, of what counts after the deadline") {
    const auto course = course_of("title = \"T\"\n[[exercise]]\nnumber = \"02\"\nweight = 3\n"
                                  "[[exercise]]\nnumber = \"03\"\ndeadline = \"2026-01-31 11:59\"\nlate = 0.5\n");
    const std::vector<Grade> grades{made("a", "02_ray_sphere", 10000, Outcome::pass),
                                    made("a", "03_ray_triangle", 8000, Outcome::wrong),
                                    made("b", "02_ray_sphere", 5000, Outcome::wrong)};
    const auto table = class_table(course, grades);
    REQUIRE(table.students.size() == 2);
    CHECK(table.students[0].total == 85);  // (3 x 100 + 1 x 80 / 2) / 4
    CHECK(table.students[0].results[1].late);
    CHECK(table.students[1].total == 37.5);
    CHECK(table.students[1].results[1].grade == nullptr);
    CHECK(table.assignments[0].mean == 75);
}

TEST_CASE("a total is over the exercises that were asked for, and over equal ones where these have no weight") {
    const auto course = course_of("[[exercise]]\nnumber = \"02\"\nweight = 3\n"
                                  "[[exercise]]\nnumber = \"03\"\nweight = 0\n");
    const std::vector<Grade> spheres_alone{made("a", "02_ray_sphere", 10000, Outcome::pass)};
    CHECK(class_table(course, spheres_alone).assignments.size() == 1);
    CHECK(class_table(course, spheres_alone).students[0].total == 100);
    const std::vector<Grade> triangles_alone{made("a", "03_ray_triangle", 8000, Outcome::wrong)};
    CHECK(class_table(course, triangles_alone).students[0].total == 80);
}

TEST_CASE("submissions are alike by their hint, or else by their answers, and the largest group comes first") {
    const std::string e = "02_ray_sphere";
    const std::vector<Grade> grades{made("a", e, 0, Outcome::wrong, "far_root", "1"),
                                    made("b", e, 0, Outcome::wrong, "far_root", "2"),
                                    made("c", e, 0, Outcome::wrong, "", "3"),
                                    made("d", e, 0, Outcome::wrong, "", "3"),
                                    made("e", e, 0, Outcome::wrong, "", "3"),
                                    made("f", e, 10000, Outcome::pass),
                                    made("g", e, 0, Outcome::internal)};
    const auto table = class_table({}, grades);
    const auto& summary = table.assignments[0];
    REQUIRE(summary.alike.size() == 2);
    CHECK(summary.alike[0].students == std::vector<std::string>{"c", "d", "e"});
    CHECK(summary.alike[1].hint_id == "far_root");
    CHECK(summary.distribution[10] == 1);
    CHECK(summary.distribution[0] == 5);
    CHECK(summary.internal == 1);
}

TEST_CASE("submissions that end differently are not alike, whatever parts they fail in") {
    std::vector<Grade> grades;
    for (const auto* end : {"killed by signal 11", "killed by signal 8", "killed by signal 11"}) {
        grades.push_back(made("student " + std::to_string(grades.size()), "02_ray_sphere", 0, Outcome::crash));
        grades.back().summary = end;
    }
    const auto table = class_table({}, grades);
    REQUIRE(table.assignments[0].alike.size() == 2);
    CHECK(table.assignments[0].alike[0].shared == "killed by signal 11");
    CHECK(table.assignments[0].alike[0].students.size() == 2);
    CHECK(table.assignments[0].alike[1].shared == "killed by signal 8");
}

TEST_CASE("a name is no formula in a spreadsheet, no element of a page and no end of a field") {
    const std::vector<Grade> grades{made("=1+1,\"x\"", "02_ray_sphere", 10000, Outcome::pass),
                                    made("<script>alert(1)</script>", "02_ray_sphere", 0, Outcome::wrong)};
    const auto table = class_table({}, grades);
    CHECK(class_csv(table).find("\n\"'=1+1,\"\"x\"\"\",100.00,") != std::string::npos);
    CHECK(class_page(table).find("<script>alert") == std::string::npos);
    CHECK(student_page(table, table.students[0]).find("<script>alert") == std::string::npos);
    CHECK(json_from_text(class_json(table), "the table")["students"].size() == 2);
}

TEST_CASE("what a course.toml lacks or has too much is an Error with its line") {
    const auto refused = [](const std::string& text, const std::string& expected) {
        try {
            course_of(text);
            FAIL(text << " was taken");
        } catch (const Error& error) {
            INFO(error.what());
            CHECK(std::string(error.what()).find(expected) != std::string::npos);
        }
    };
    refused("title = 3", "course_trial.toml:1: expected title to be a text");
    refused("title = \"T\"", "expected an [[exercise]]");
    refused("[[exercise]]\nweight = 1", ":1: expected a text 'number'");
    refused("[[exercise]]\nnumber = \"99\"", "expected an exercise");
    refused("[[exercise]]\nnumber = \"02\"\nweight = -1", ":3: expected weight to be a number from 0");
    refused("[[exercise]]\nnumber = \"02\"\ndeadline = \"tomorrow\"", ":3: expected deadline to be a moment");
    for (const std::string date : {"2026-02-30 23:59", "2026-04-31 12:00", "2027-02-29 00:00"})
        refused("[[exercise]]\nnumber = \"02\"\ndeadline = \"" + date + "\"", ":3: expected deadline to be a moment");
    refused("[[exercise]]\nnumber = \"02\"\nlatte = 1", ":3: expected one of the keys");
    refused("[[exercise]]\nnumber = \"77\"", "course_trial.toml:2: expected an exercise");
    refused("[[exercise]]\nnumber = \"02\"\n[[exercise]]\nnumber = \"02_ray_sphere\"",
            "course_trial.toml:4: expected number to be an exercise of its own");
    refused("[[exercise]]\nnumber = \"02\"\nweight = 0", "course_trial.toml: expected a weight above 0");
}

TEST_CASE("a student has one entry, which may hold several exercises") {
    const auto folder = class_folder / "entries";
    fs::remove_all(folder);
    fs::create_directories(folder / "ann");
    const auto two = course_of("[[exercise]]\nnumber = \"02\"\n[[exercise]]\nnumber = \"03\"\n");
    CHECK(handed_in(folder, two).size() == 2);

    const auto one = course_of("[[exercise]]\nnumber = \"02\"\n");
    write_file(folder / "ann-b.cpp", "");  // stands between the two entries of ann
    CHECK(handed_in(folder, one).size() == 2);
    write_file(folder / "ann.cpp", "");
    CHECK_THROWS_WITH(handed_in(folder, one),
                      Catch::Contains("ann.cpp: expected one entry for each student, found two of ann"));
}

TEST_CASE("a name that leaves no room for that of its result is refused before anything is graded") {
    const auto folder = class_folder / "long";
    fs::remove_all(folder);
    const auto one = course_of("[[exercise]]\nnumber = \"02\"\n");
    write_file(folder / (std::string(250, 'a') + ".cpp"), "");
    CHECK(handed_in(folder, one).size() == 1);
    write_file(folder / (std::string(251, 'b') + ".cpp"), "");
    CHECK_THROWS_WITH(handed_in(folder, one),
                      Catch::Contains("bbb.cpp: expected a student's name of at most 250 bytes, "
                                      "found one of 251"));
}

TEST_CASE("what is no submission has a result that says so, and a class without any is refused") {
    const auto folder = class_folder / "odd";
    fs::remove_all(folder);
    fs::remove_all(class_folder / "odd_report");
    fs::create_directories(folder / "two\nlines");
    fs::create_symlink(spheres + "right/geometric.cpp", folder / "linked.cpp");
    fs::create_symlink("lost", folder / "lost");
    fs::create_symlink("../odd_report", folder / "report");
    fs::create_symlink("..", folder / "above");
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    const auto done = run_class({"02", "--class", "odd", "-o", "odd_report", "--seed", "7", "--points", "50"});
    INFO(done.output << done.errors);
    CHECK(done.code == 0);
    CHECK(says(done, "6 submissions graded"));
    const auto result = [](const std::string& student) {
        return read_json(class_folder / "odd_report/results/02_ray_sphere" / (student + ".json"));
    };
    for (const auto* link : {"linked", "lost", "report", "above"}) {
        CHECK(result(link)["verdict"] == "no_submission");
        CHECK(result(link)["summary"] == std::string("what was handed in is a symbolic link, which is not followed: "
                                                     "hand in what it leads to"));
        CHECK(result(link)["student"] == link);
        CHECK(result(link)["max_score"] == 50.0);
        CHECK(result(link)["tests"].size() == result("two\nlines")["tests"].size());
    }
    CHECK(result("pipe")["verdict"] == "no_submission");

    // A name of two lines is found again in the list of a report's submissions.
    const auto merged = run_class({"--merge", "odd_report"});
    INFO(merged.output << merged.errors);
    CHECK(merged.code == 0);

    fs::remove_all(class_folder / "nobody_report");
    fs::create_directories(class_folder / "nobody/.hidden");
    const auto nobody = run_class({"02", "--class", "nobody", "-o", "nobody_report"});
    check_could_not(nobody, "nobody: expected a submission, found none");
    CHECK(!fs::exists(class_folder / "nobody_report"));
}

TEST_CASE("a report does not lie among the submissions, where the next run would take it for one") {
    const auto folder = class_folder / "among";
    fs::remove_all(folder);
    fs::create_directories(folder / "ann");
    const std::string itself = "expected an output that is no input, found the same file as among";
    const std::string in_it = "expected an output outside of the inputs, found one in the folder among";
    for (const auto& [report, words] : std::map<std::string, std::string>{
             {"among", itself}, {"among/", itself}, {"among/report", in_it}, {"odd/../among/deep/report", in_it}}) {
        check_could_not(run_class({"02", "--class", "among", "-o", report}), report + ": " + words);
        CHECK(std::distance(fs::directory_iterator(folder), {}) == 1);
    }
    CHECK(run_class({"02", "--class", "among", "-o", "among/../among_report"}).code == 0);
}

TEST_CASE("reports that cannot be merged leave nothing, and the message names the part") {
    const std::string alice = "results/02_ray_sphere/alice.json";
    for (const auto* report : {"good", "bad", "other", "none"}) fs::remove_all(class_folder / report);
    write_file(class_folder / "good" / alice, as_json(made("alice", "02_ray_sphere", 10000, Outcome::pass)));
    write_file(class_folder / "good/results/02_ray_sphere/bob.json",
               as_json(made("bob", "02_ray_sphere", 0, Outcome::wrong)));
    write_file(class_folder / "bad" / alice, "{\"format\": \"raylab.res");
    write_file(class_folder / "other" / alice, as_json(made("alice", "02_ray_sphere", 0, Outcome::wrong)));
    const auto refused = [](const std::string& first, const std::string& second, const std::string& words) {
        check_could_not(run_class({"--merge", first, second, "-o", "none"}), words);
        CHECK(!fs::exists(class_folder / "none"));
    };
    refused("bad", "good", "bad/" + alice + ":1 byte 22: expected JSON");
    refused("good", "bad", "bad/" + alice + ":1 byte 22: expected JSON");
    refused("good", "other", "other/" + alice + ": expected the same result as in good/" + alice + ", found another");
    refused("good", "odd", "odd: expected a report with results, found none");
}

TEST_CASE("an option that would do nothing is refused, with what does it") {
    const auto refused = [](const std::vector<std::string>& words, const std::string& reason) {
        check_could_not(run_class(words), reason);
    };
    fs::remove_all(class_folder / "idle");
    const auto answer = spheres + "right/geometric.cpp";
    refused({"02", "--class", "among", "-o", "idle", "--student", "ann"}, "expected no --student with --class");
    refused({"02", "--class", "among", "-o", "idle", "--format", "csv"}, "expected no --format with --class");
    refused({"02", "--class", "among", "-o", "idle", "--submission", answer}, "expected no --submission with --class");
    refused({"02", "--submission", answer, "--regrade"}, "expected no --regrade without --class");
    refused({"02", "--submission", answer, "--pseudonyms"}, "expected no --pseudonyms without --class");
    refused({"02", "--submission", answer, "--picture", "p.exr"}, "expected no --picture with --submission");
    refused({"--merge", "good", "--regrade"}, "expected no --regrade with --merge");
    CHECK(!fs::exists(class_folder / "idle"));
}

TEST_CASE("a result whose student is no longer in the class says so") {
    for (const auto* name : {"leaving", "left"}) fs::remove_all(class_folder / name);
    fs::create_directories(class_folder / "leaving/ann");
    fs::create_directories(class_folder / "leaving/bob");
    const std::vector<std::string> words{"02", "--class", "leaving", "-o", "left", "--seed", "7"};
    const auto present = run_class(words);
    CHECK_FALSE(says(present, "no longer"));
    CHECK(present.errors.empty());
    fs::remove(class_folder / "leaving/bob");
    CHECK(says(run_class(words), "no longer in the class, but in its report: 02_ray_sphere/bob"));
    const auto page = read_file(class_folder / "left/index.html");
    const auto rows = page.substr(page.find("<h2>Students</h2>"));
    CHECK(rows.find("no_submission, no longer in the class") != std::string::npos);
    CHECK(rows.find("no longer in the class") == rows.rfind("no longer in the class"));
}

TEST_CASE("a class is graded once, goes on where it was stopped, and in parts gives the same") {
    fs::remove_all(class_folder);
    hand_in("one", "right/geometric.cpp");
    hand_in("two", "mistakes/far_root.cpp");
    hand_in("three", "mistakes/far_root.cpp");
    fs::create_directories(class_folder / "class/four");
    const auto first = run_class({"02", "--class", "class", "-o", "whole", "--seed", "7"});
    INFO(first.output << first.errors);
    CHECK(first.code == 0);
    CHECK(says(first, "4 submissions graded"));
    const auto csv = read_file(class_folder / "whole/grades.csv");
    CHECK(csv.find("four,0.00,0.00,no_submission,,\r\n") != std::string::npos);
    CHECK(csv.find("one,100.00,100.00,pass,,\r\n") != std::string::npos);
    CHECK(fs::exists(class_folder / "whole/students/0004.html"));

    // Half of a file, as of a disk that was full, and an internal result are graded again; the others are kept.
    write_file(class_folder / "whole/results/02_ray_sphere/two.json", "{\"format\": \"raylab.res");
    const auto again = run_class({"02", "--class", "class", "-o", "whole", "--seed", "7"});
    CHECK(says(again, "2 submissions graded, 2 unchanged"));

    for (const auto* part : {"1/2", "2/2"})
        CHECK(run_class({"02", "--class", "class", "-o", std::string("part_") + part[0], "--part", part, "--seed", "7"})
                  .code == 0);
    CHECK(says(run_class({"02", "--class", "class", "-o", "quarter", "--part", "1/4"}), "1 submission graded"));
    CHECK(run_class({"--merge", "part_1", "-o", "merged"}).code == 1);  // two are missing
    CHECK(run_class({"--merge", "part_1", "part_2", "-o", "merged"}).code == 0);
    CHECK(results("merged") == results("whole"));
    CHECK(read_file(class_folder / "merged/grades.csv") == csv);
}

TEST_CASE("cases that have changed are told, and graded again by the same seed only where that is asked for") {
    const auto file = class_folder / "whole/results/02_ray_sphere/two.json";
    auto json = read_json(file);
    json["cases_sha256"] = std::string(64, '0');
    json["tests"][0]["score"] = 1.25;
    write_file(file, json.dump());
    const std::vector<std::string> words{"02", "--class", "class", "-o", "whole", "--seed", "7"};
    CHECK(says(run_class(words), "1 of these were asked cases that have changed since: --regrade"));
    CHECK(read_json(file)["cases_sha256"] == std::string(64, '0'));
    auto regrade = words;
    regrade.emplace_back("--regrade");
    const auto regraded = run_class(regrade);
    CHECK(says(regraded, "02_ray_sphere two: "));
    CHECK(says(regraded, " points (wrong), before "));
    CHECK(read_json(file)["cases_sha256"] != std::string(64, '0'));
}

TEST_CASE("with pseudonyms no name is left in the report, and without a key there are none") {
    fs::remove_all(class_folder / "class");
    write_file(class_folder / "class/somebody.cpp", "this is no C++");
    write_file(class_folder / "class/=some, \"body\".cpp", "this is no C++");
    fs::create_symlink("somebody.cpp", class_folder / "class/somebody's link.cpp");
    write_file(class_folder / "course.key", "sixteen bytes and more");
    CHECK(run_class({"02", "--class", "class", "-o", "secret", "--pseudonyms"}).code == 2);
    const auto done = run_class({"02", "--class", "class", "-o", "secret", "--pseudonyms", "--key", "course.key"});
    INFO(done.output << done.errors);
    CHECK(done.code == 0);
    for (const auto& entry : fs::recursive_directory_iterator(class_folder / "secret")) {
        CHECK(entry.path().string().find("somebody") == std::string::npos);
        if (entry.is_regular_file()) CHECK(read_file(entry.path()).find("somebody") == std::string::npos);
    }
    const auto names = class_folder / "secret.names.csv";
    CHECK(read_file(names).find(",somebody\r\n") != std::string::npos);
    CHECK(read_file(names).find(",\"'=some, \"\"body\"\"\"\r\n") != std::string::npos);
    CHECK(fs::status(names).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

#include "class_grading.h"

#include "formats.h"
#include "grade_json.h"
#include "official_grade.h"
#include "prepared_header.h"
#include "seeds.h"
#include "sha256.h"
#include "submission.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/program.h"
#include "raylab/base/read_json.h"
#include "raylab/base/temporary.h"
#include "raylab/base/tiles.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <climits>
#include <map>
#include <mutex>
#include <set>
#include <string_view>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

// Longer than any grading takes: 30 s of compiling, and answers that are asked four times.
constexpr double patience_for_one = 600;

fs::path result_file(const HandedIn& handed, const ClassTerms& terms) {
    return terms.report / "results" / handed.exercise / (name_in_report(handed.student, terms) + result_extension);
}

std::optional<Grade> earlier_result(const fs::path& file) {
    if (!fs::exists(file)) return std::nullopt;
    try {
        return grade_from_json(read_json(file), file.string());
    } catch (const Error&) {
        return std::nullopt;  // half a file of a full disk: graded again
    }
}

std::uint64_t seed_for(const HandedIn& handed, const ClassTerms& terms) {
    if (terms.seed) return *terms.seed;
    return terms.key ? seed_by_key(*terms.key, handed.exercise, handed.student) : fresh_seed();
}

bool has_other_cases(const Grade& grade) {
    if (!grade.seed) return false;
    const auto& asked = exercise(grade.exercise);
    return cases_sha256(asked, asked.cases(*grade.seed)) != grade.cases_sha256;
}

// Whether what was graded then is what would be graded now.
bool still_holds(const Grade& grade, const HandedIn& handed, const ClassTerms& terms) {
    if (grade.outcome == Outcome::internal || grade.submitted.sha256.empty()) return false;
    if ((terms.seed || terms.key) && grade.seed != seed_for(handed, terms)) return false;
    const auto now = find_submission(exercise(handed.exercise), handed.path);
    return now.submitted.sha256 == grade.submitted.sha256;
}

std::string student_of(const fs::path& entry) {
    std::error_code lost;  // a link that leads nowhere
    return (fs::is_directory(entry, lost) ? entry.filename() : entry.stem()).string();
}

void refuse_long_names(const std::vector<fs::path>& entries) {
    constexpr auto longest = NAME_MAX - std::string_view(result_extension).size();
    for (const auto& entry : entries)
        if (const auto bytes = student_of(entry).size(); bytes > longest)
            throw Error({entry.string()}, fmt::format("a student's name of at most {} bytes", longest),
                        fmt::format("one of {}", bytes));
}

// A student's second entry would be graded into the first one's result. Other names may stand between the two.
void refuse_second_entries(const std::vector<fs::path>& entries) {
    std::set<std::string> students;
    for (const auto& entry : entries)
        if (const auto student = student_of(entry); !students.insert(student).second)
            throw Error({entry.string()}, "one entry for each student", "two of " + student);
}

// Compiled headers are worth it from this many submissions of an exercise on: each saves half as much as they cost.
constexpr std::size_t submissions_for_headers = 4;

void prepare_headers(const std::vector<HandedIn>& submissions, const fs::path& folder) {
    std::map<std::string, std::size_t> counts;
    for (const auto& handed : submissions) ++counts[handed.exercise];
    for (const auto& [name, count] : counts)
        if (count >= submissions_for_headers) prepare_header(exercise(name), folder);
}

// The path of this program, of which each submission gets a process.
Grade graded_apart(const HandedIn& handed, std::uint64_t seed, const ClassTerms& terms, const fs::path& prepared) {
    const auto file = result_file(handed, terms);
    fs::create_directories(file.parent_path());
    std::vector<std::string> words{"grade",        handed.exercise,
                                   "--submission", handed.path.string(),
                                   "--student",    name_in_report(handed.student, terms),
                                   "--seed",       std::to_string(seed),
                                   "--prepared",   prepared.string(),
                                   "--points",     std::to_string(terms.most / 100),
                                   "--format",     "json",
                                   "-o",           file.string()};
    words.insert(words.end(), terms.words.begin(), terms.words.end());
    const auto result = run_process(fs::read_symlink("/proc/self/exe"), words, {.timeout = patience_for_one});
    auto grade = earlier_result(file).value_or(Grade{.exercise = handed.exercise});
    if (grade.outcome != Outcome::internal || result.code == static_cast<int>(ExitCode::could_not)) return grade;
    grade.student = name_in_report(handed.student, terms);
    grade.summary = failure_of("the grader", result);
    write_file(file, as_json(grade));
    return grade;
}

// Counts of several threads.
class ClassCounts {
public:
    void count_kept(bool other_cases) {
        const std::scoped_lock lock(mutex_);
        ++run_.kept;
        run_.other_cases += other_cases;
    }

    void count_graded(const Grade& now, const std::optional<Grade>& before) {
        const std::scoped_lock lock(mutex_);
        ++run_.graded;
        run_.internal += now.outcome == Outcome::internal;
        if (before && before->outcome != Outcome::internal &&
            (before->points() != now.points() || before->outcome != now.outcome))
            run_.changes.push_back(fmt::format("{} {}: {} points ({}), before {} ({})", now.exercise, now.student,
                                               points_text(now.points()), to_string(now.outcome),
                                               points_text(before->points()), to_string(before->outcome)));
    }

    ClassRun sorted() && {
        std::ranges::sort(run_.changes);
        return std::move(run_);
    }

private:
    std::mutex mutex_;
    ClassRun run_;
};

void grade_one(const HandedIn& handed, const ClassTerms& terms, const fs::path& prepared, ClassCounts& counts) {
    const auto before = earlier_result(result_file(handed, terms));
    const bool holds = before && still_holds(*before, handed, terms);
    const bool other_cases = holds && has_other_cases(*before);
    if (holds && !(other_cases && terms.regrade)) return counts.count_kept(other_cases);
    const auto seed = other_cases ? *before->seed : seed_for(handed, terms);
    counts.count_graded(graded_apart(handed, seed, terms, prepared), before);
}

}  // namespace

std::string name_in_report(const std::string& student, const ClassTerms& terms) {
    if (!terms.pseudonyms) return student;
    constexpr std::size_t digits = 10;  // two of 10 000 students share a name once in 20 000 courses
    return "p" + hexadecimal(hmac_sha256(*terms.key, "pseudonym\n" + student)).substr(0, digits);
}

std::vector<HandedIn> handed_in(const fs::path& folder, const Course& course) {
    if (!fs::is_directory(folder)) throw Error({folder.string()}, "a folder of submissions", "none");
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto name = entry.path().filename().string();
        if (name.starts_with(".") || name == "course.toml") continue;
        if (fs::is_regular_file(entry.symlink_status()) && course.assignments.size() > 1)
            throw Error({entry.path().string()}, "a folder for each student, since there are several exercises",
                        "a file");
        entries.push_back(entry.path());
    }
    if (entries.empty()) throw Error({folder.string()}, "a submission", "none");
    std::ranges::sort(entries);
    refuse_second_entries(entries);
    refuse_long_names(entries);
    std::vector<HandedIn> all;
    for (const auto& assignment : course.assignments)
        for (const auto& entry : entries) all.push_back({student_of(entry), assignment.exercise->folder, entry});
    return all;
}

ClassRun grade_class(const std::vector<HandedIn>& submissions, const ClassTerms& terms) {
    const ScratchFolder prepared;
    prepare_headers(submissions, prepared.path());
    ClassCounts counts;
    for_each_piece(submissions.size(), 1, terms.threads, [&](std::size_t begin, std::size_t) {
        grade_one(submissions[begin], terms, prepared.path(), counts);
    });
    return std::move(counts).sorted();
}

}  // namespace raylab::grading

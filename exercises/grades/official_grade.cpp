#include "official_grade.h"

#include "asking.h"
#include "compiling.h"
#include "moment.h"
#include "sha256.h"
#include "submission.h"

#include "raylab/base/with_all_replaced.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace raylab::grading {

namespace {

// The cases that are the same for everybody, asked after wrong answers only, for no points.
constexpr std::uint64_t seed_for_fingerprints = 1;

std::string lab_version() {
    static const std::string version = [] {
        std::string text;
        for (const auto& [name, value] : machine_facts())
            if (name == "raylab" || name == "commit") text += (text.empty() ? "" : " ") + value;
        return text;
    }();
    return version;
}

GradePart part_of(const GroupScore& score) {
    return {.name = score.group,
            .right = score.right,
            .total = score.total,
            .message = fmt::format("{} of {} cases right", score.right, score.total)};
}

GradePart part_of(const WorkScore& score) {
    GradePart part{.name = score.rays, .right = score.passed() ? 1u : 0u, .total = 1};
    if (!score.yours)
        part.message = fmt::format("stopped at {:g} times the reference's questions", work_watched);
    else
        part.message = fmt::format("{:.1f} {}, at most {:.1f} allowed{}", *score.yours, score.unit, score.allowed,
                                   score.strayed ? fmt::format("; {} rays hit something else", score.strayed) : "");
    return part;
}

// The parts of an exercise do not depend on how far a submission came.
std::vector<GradePart> parts_of(const Exercise& exercise, const Verdict& verdict, Hundredths most) {
    std::vector<GradePart> parts;
    for (const auto& score : verdict.groups)
        if (score.kind == Case::Kind::graded) parts.push_back(part_of(score));
    if (verdict.work.empty())
        for (const auto& task : exercise.work)
            parts.push_back({.name = task.rays, .right = 0, .total = 1, .message = "not counted"});
    for (const auto& score : verdict.work) parts.push_back(part_of(score));
    return with_equal_points(std::move(parts), most);
}

std::vector<GradePart> no_parts(const Exercise& exercise, const std::vector<Case>& cases, Hundredths most) {
    Verdict verdict;
    for (const auto& question : cases) {
        const auto known = std::ranges::find_if(verdict.groups, [&](const auto& score) {
            return score.group == question.group && score.kind == question.kind;
        });
        if (known != verdict.groups.end())
            ++known->total;
        else
            verdict.groups.push_back({question.group, question.kind, 0, 1});
    }
    return parts_of(exercise, verdict, most);
}

// Whether one and the same answer, "no hit", is right for all cases of the part.
bool may_be_guessed(const Exercise& exercise, const std::vector<Case>& cases, const GradePart& part) {
    std::vector<Case> of_part;
    std::ranges::copy_if(cases, std::back_inserter(of_part), [&](const Case& question) {
        return question.group == part.name && question.kind == Case::Kind::graded;
    });
    if (of_part.empty()) return false;  // counted work
    const auto first = answers_of(exercise, exercise.reference, {of_part.front()});
    return std::ranges::all_of(of_part, [&](const Case& question) {
        return exercise.judge(question, first).outcome == Judgement::Outcome::right;
    });
}

std::vector<GradePart> without_guesses(std::vector<GradePart> parts, const Exercise& exercise,
                                       const std::vector<Case>& cases) {
    std::vector<bool> guessable;
    for (const auto& part : parts) guessable.push_back(may_be_guessed(exercise, cases, part));
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!guessable[i] && parts[i].passed()) return parts;
    for (auto& part : parts) {
        if (part.points > 0) part.message += "; no points, since one answer for all cases would be right, too";
        part.points = 0;
    }
    return parts;
}

Outcome outcome_of(const Exercise& exercise, const JudgedAnswers& asked) {
    switch (asked.answers.end) {
        case Answers::End::unfinished:
            return Outcome::unfinished;
        case Answers::End::incomplete:
            return Outcome::incomplete;
        case Answers::End::crashed:
            return Outcome::crash;
        case Answers::End::timed_out:
            return Outcome::timeout;
        case Answers::End::out_of_memory:
            return Outcome::memory;
        case Answers::End::flooded:
            return Outcome::output_limit;
        case Answers::End::policy:
            return Outcome::policy;
        case Answers::End::complete:
            break;
    }
    const auto& verdict = asked.verdict;
    if (verdict.passed()) return Outcome::pass;
    if (verdict.works_too_much()) return Outcome::too_much_work;
    if (!verdict.first_wrong) return Outcome::wrong;
    const auto index = verdict.first_wrong->index;
    const auto answer = std::span(asked.answers.values).subspan(index * exercise.outputs, exercise.outputs);
    const bool finite = exercise.judge(asked.cases[index], answer).outcome != Judgement::Outcome::nonfinite;
    return finite ? Outcome::wrong : Outcome::nonfinite;
}

// Messages of the compiler with the name that was asked for: a path would tell the course's folders, and names in them.
std::string with_name(const std::string& messages, const std::filesystem::path& file, const std::string& name) {
    return with_all_replaced(messages, file.lexically_normal().string(), name);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string summary_of(const Grade& grade, const JudgedAnswers& asked) {
    const auto right = fmt::format("{} of {} graded cases right", asked.verdict.right, asked.verdict.total);
    if (!asked.ended.empty()) return first_line(asked.ended);
    if (grade.outcome == Outcome::too_much_work) return right + ", but more work than is allowed";
    return right;
}

// The answers to the common cases that are wrong, to six digits: another program with the same mistake rounds the last
// of a double's sixteen otherwise.
std::string fingerprint_of(const Exercise& exercise, const Workplace& workplace) {
    const auto cases = exercise.cases(seed_for_fingerprints);
    const auto answers = run(exercise, workplace, inputs_of(cases));
    std::string wrong;
    for (std::size_t i = 0; (i + 1) * exercise.outputs <= answers.values.size(); ++i) {
        const auto answer = std::span(answers.values).subspan(i * exercise.outputs, exercise.outputs);
        if (exercise.judge(cases[i], answer).outcome == Judgement::Outcome::right) continue;
        wrong += fmt::format("{}:", i);
        for (const double number : answer) wrong += fmt::format(" {:.5e}", number);
    }
    return wrong.empty() ? "" : hexadecimal(sha256(wrong)).substr(0, 16);
}

void add_hint(Grade& grade, const Exercise& exercise, const Verdict& verdict) {
    if (!verdict.hint) return;
    grade.hint_id = *verdict.hint;
    const auto hints = read_hints(exercise);
    if (const auto* const text = hints.text(*verdict.hint)) grade.hint = *text;
}

void add_answers(Grade& grade, const Exercise& exercise, const Workplace& workplace, const Terms& terms) {
    const auto asked = ask(exercise, workplace, *grade.seed);
    grade.outcome = outcome_of(exercise, asked);
    grade.summary = summary_of(grade, asked);
    grade.details = asked.ended;
    grade.printed = asked.answers.printed;
    grade.answer_seconds = asked.answers.seconds;
    grade.parts = without_guesses(parts_of(exercise, asked.verdict, terms.most), exercise, asked.cases);
    if (const auto& wrong = asked.verdict.first_wrong)
        grade.first_wrong = FirstWrong{wrong->index, wrong->group, wrong->story, wrong->expected, wrong->got};
    add_hint(grade, exercise, asked.verdict);
    if (grade.outcome == Outcome::wrong || grade.outcome == Outcome::nonfinite)
        grade.fingerprint = fingerprint_of(exercise, workplace);
}

Grade begun(const Exercise& exercise, std::uint64_t seed, Hundredths most) {
    const auto cases = exercise.cases(seed);
    Grade grade{.exercise = exercise.folder, .parts = no_parts(exercise, cases, most), .most = most};
    grade.seed = seed;
    grade.cases_sha256 = cases_sha256(exercise, cases);
    grade.lab = lab_version();
    grade.began = to_string(now());
    return grade;
}

}  // namespace

std::string cases_sha256(const Exercise& exercise, const std::vector<Case>& cases) {
    std::string bytes;
    const auto add = [&](std::span<const double> numbers) {
        bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
    };
    for (const auto& question : cases) {
        bytes += fmt::format("{}\n{}\n", question.group, static_cast<int>(question.kind));
        add(question.input);
    }
    add(answers_of(exercise, exercise.reference, cases));
    return hexadecimal(sha256(bytes));
}

Grade official_grade(const Exercise& exercise, const std::filesystem::path& file_or_folder, const Terms& terms) {
    auto grade = begun(exercise, terms.seed, terms.most);
    grade.isolation = terms.isolation;
    auto submission = find_submission(exercise, file_or_folder);
    grade.submitted = std::move(submission.submitted);
    if (!submission.fault.empty()) {
        grade.outcome = Outcome::no_submission;
        grade.summary = submission.fault;
    } else {
        const Workplace workplace(exercise, terms.isolation, terms.prepared);
        const auto compiled = compile(exercise, workplace, submission.file);
        grade.compile_seconds = compiled.seconds;
        grade.compiler = with_name(compiled.diagnostics, submission.file, exercise.slot + ".cpp");
        if (compiled.succeeded) {
            add_answers(grade, exercise, workplace, terms);
        } else {
            grade.outcome = compiled.refused ? Outcome::refused : Outcome::does_not_compile;
            grade.summary = compiled.refused ? "the file is not taken as an answer" : "the file does not compile";
        }
    }
    grade.ended = to_string(now());
    return grade;
}

}  // namespace raylab::grading

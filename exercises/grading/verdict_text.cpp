#include "verdict_text.h"

#include "isolation_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace raylab::grading {

namespace {

std::string indented(const std::string& text, const std::string& by) {
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);) result += by + line + "\n";
    return result;
}

std::string group_lines(const Verdict& verdict, Case::Kind kind) {
    std::size_t widest = 0;
    for (const auto& score : verdict.groups) widest = std::max(widest, score.group.size());
    std::string text;
    for (const auto& [group, of_kind, right, total] : verdict.groups)
        if (of_kind == kind)
            text += fmt::format("    {}  {:<{}}  {:>3} of {} right\n", right == total ? "✓" : "✗", group, widest, right,
                                total);
    return text;
}

std::string in_words(const WorkScore& score) {
    const std::string beside =
        fmt::format("the reference {:.1f}, at most {:.1f} allowed", score.reference, score.allowed);
    if (!score.yours)
        return fmt::format("stopped at {:g} times the reference's questions ({}: {})", work_watched, score.unit,
                           beside);
    const std::string strayed =
        score.strayed == 0 ? "" : fmt::format("; {} of {} rays hit something else", score.strayed, score.total);
    return fmt::format("{:.1f} {}, {}{}", *score.yours, score.unit, beside, strayed);
}

// One of the rays that met something else, and where it went wrong.
std::string astray_lines(const WrongCase& wrong) {
    return fmt::format(
        "    One of them goes wrong at question {} of {}:\n{}        expected   {}\n        got        {}\n",
        wrong.index, wrong.group, indented(wrong.story, "        "), wrong.expected, wrong.got);
}

std::string work_lines(const Verdict& verdict) {
    std::size_t widest = 0;
    for (const auto& score : verdict.work) widest = std::max(widest, score.rays.size());
    std::string text;
    for (const auto& score : verdict.work)
        text += fmt::format("    {}  {:<{}}  {}\n", score.passed() ? "✓" : "✗", score.rays, widest, in_words(score));
    for (const auto& score : verdict.work)
        if (score.astray) {
            text += astray_lines(*score.astray);
            break;
        }
    if (!verdict.work_ended.empty())
        text += "    ✗  not counted: the function did not come to an end, " + verdict.work_ended + "\n";
    return text.empty() ? "" : "\n  Counted work, where a structure asks your function again and again:\n" + text;
}

std::string word_for(Answers::End end) {
    switch (end) {
        case Answers::End::complete:
            return "complete";
        case Answers::End::unfinished:
            return "unfinished";
        case Answers::End::incomplete:
            return "incomplete";
        case Answers::End::crashed:
            return "crash";
        case Answers::End::timed_out:
            return "timeout";
        case Answers::End::out_of_memory:
            return "memory";
        case Answers::End::policy:
            return "policy";
        case Answers::End::flooded:
            return "output_limit";
    }
    return "internal";
}

void add_conditions(nlohmann::ordered_json& json, const Conditions& conditions) {
    json["seed"] = conditions.seed;
    json["isolation"] = to_json(conditions.isolation);
}

}  // namespace

std::string quoted(const std::string& printed) { return indented(printed, "    | "); }

std::string to_text(const Exercise& exercise, const Verdict& verdict, const Hints& hints) {
    std::string text = group_lines(verdict, Case::Kind::graded) + work_lines(verdict);
    if (verdict.first_wrong) {
        const auto& wrong = *verdict.first_wrong;
        text += fmt::format("\n  The first wrong answer (case {}, {}):\n{}    expected   {}\n    "
                            "got        {}\n",
                            wrong.index, wrong.group, indented(wrong.story, "    "), wrong.expected, wrong.got);
    }
    if (!verdict.passed()) {
        const std::string unknown = verdict.first_wrong ? "Follow the case above by hand."
                                                        : "Each answer to a graded case is right: look at what follows "
                                                          "from one for the next.";
        const auto* const hint = verdict.hint ? hints.text(*verdict.hint) : nullptr;
        text += "\n  What is probably wrong:\n" + indented(hint ? *hint : "Nothing known by sight. " + unknown, "    ");
        if (hint && !verdict.evidence.empty()) text += "    (" + verdict.evidence + ")\n";
        text += fmt::format("    More help: ./raylab check {} --hint 1   (to {})\n",
                            exercise.folder.substr(0, exercise.folder.find('_')), hints.levels.size());
    }
    if (const auto lines = group_lines(verdict, Case::Kind::adversarial); !lines.empty())
        text += "\n  How sturdy is yours? Hard on any method, shown and never counted:\n" + lines;
    if (verdict.passed())
        text += fmt::format("\n  A look at the reference{}:\n{}", hints.solution.empty() ? "" : ", " + hints.solution,
                            indented(hints.look, "    "));
    text += fmt::format("\n{}: {} of {} graded cases right", verdict.passed() ? "PASSED" : "NOT YET", verdict.right,
                        verdict.total);
    if (!verdict.work.empty())
        text += fmt::format(", {} of {} counts of work", std::ranges::count_if(verdict.work, &WorkScore::passed),
                            verdict.work.size());
    return text + "\n";
}

std::string to_text(const Exercise& exercise, const Answers& answers) {
    std::string text;
    switch (answers.end) {
        case Answers::End::unfinished:
            text = fmt::format("{} is not written yet: exercises/{}/README.md says what to write", exercise.slot,
                               exercise.folder);
            break;
        case Answers::End::crashed:
            text = "the function did not return: " + answers.reason;
            break;
        case Answers::End::timed_out:
            text = "the function takes too long (an endless loop?): " + answers.reason;
            break;
        case Answers::End::out_of_memory:
            text = "the function needs more memory than an answer gets";
            break;
        case Answers::End::policy:
            text = "the function did what no answer has to do, and was stopped: " + answers.reason;
            break;
        case Answers::End::flooded:
            text = "the function prints more than can be read: " + answers.reason;
            break;
        case Answers::End::incomplete:
            text = "the program ended before all cases were answered: " + answers.reason;
            break;
        case Answers::End::complete:
            break;
    }
    if (answers.end != Answers::End::unfinished && !answers.printed.empty())
        text += "\n  It printed:\n" + quoted(answers.printed);
    return text + (text.ends_with('\n') ? "" : "\n");
}

std::string to_text(const Exercise& exercise, const Answers& answers, const std::vector<Case>& cases) {
    auto text = to_text(exercise, answers);
    const std::size_t answered = answers.values.size() / exercise.outputs;
    if (answers.end == Answers::End::unfinished || answered >= cases.size()) return text;
    const auto& last = cases[answered];
    text +=
        fmt::format("\n  It was asked case {}, {}:\n{}", answered, last.group, indented(exercise.story(last), "    "));
    if (answered == 0) return text;
    const auto before =
        judge(exercise, {cases.begin(), cases.begin() + static_cast<std::ptrdiff_t>(answered)}, answers.values);
    return text + fmt::format("\n  Before that, {} of {} graded cases were right:\n{}", before.right, before.total,
                              group_lines(before, Case::Kind::graded));
}

std::string to_json(const Exercise& exercise, const Verdict& verdict, const Conditions& conditions) {
    nlohmann::ordered_json json{{"exercise", exercise.folder},
                                {"verdict", verdict.passed()           ? "pass"
                                            : verdict.works_too_much() ? "too_much_work"
                                                                       : "wrong"},
                                {"right", verdict.right},
                                {"total", verdict.total},
                                {"groups", nlohmann::ordered_json::array()},
                                {"work", nlohmann::ordered_json::array()},
                                {"work_ended", nullptr},
                                {"first_wrong", nullptr},
                                {"hint_id", nullptr},
                                {"evidence", nullptr}};
    for (const auto& score : verdict.work)
        json["work"].push_back({{"rays", score.rays},
                                {"unit", score.unit},
                                {"yours", score.yours ? nlohmann::ordered_json(*score.yours) : nullptr},
                                {"reference", score.reference},
                                {"allowed", score.allowed},
                                {"strayed", score.strayed},
                                {"passed", score.passed()}});
    for (const auto& [group, kind, right, total] : verdict.groups)
        json["groups"].push_back(
            {{"group", group}, {"graded", kind == Case::Kind::graded}, {"right", right}, {"total", total}});
    if (verdict.first_wrong)
        json["first_wrong"] = {{"case", verdict.first_wrong->index},
                               {"group", verdict.first_wrong->group},
                               {"story", verdict.first_wrong->story},
                               {"expected", verdict.first_wrong->expected},
                               {"got", verdict.first_wrong->got}};
    if (!verdict.work_ended.empty()) json["work_ended"] = verdict.work_ended;
    if (verdict.hint) {
        json["hint_id"] = *verdict.hint;
        json["evidence"] = verdict.evidence;
    }
    add_conditions(json, conditions);
    return json.dump(2) + "\n";
}

std::string to_json(const Exercise& exercise, const Answers& answers, const Conditions& conditions) {
    nlohmann::ordered_json json{{"exercise", exercise.folder},
                                {"verdict", word_for(answers.end)},
                                {"reason", answers.reason},
                                {"answered", answers.values.size() / exercise.outputs}};
    add_conditions(json, conditions);
    return json.dump(2) + "\n";
}

}  // namespace raylab::grading

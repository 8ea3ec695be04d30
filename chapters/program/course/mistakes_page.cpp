#include "mistakes_page.h"

#include "hints.h"
#include "judging.h"
#include "mistake_codes.h"

#include "raylab/base/tiles.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/page_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace raylab {

using namespace grading;

namespace {

struct JudgedCode {
    std::string name;
    Verdict verdict;
};

struct JudgedMistake {
    std::string hint;  // meant for it
    std::vector<JudgedCode> codes;
};

struct JudgedExercise {
    const Exercise* exercise;
    std::vector<JudgedMistake> mistakes = {};
    std::size_t right_passed = 0;
};

JudgedExercise judged(const Exercise& exercise, std::uint64_t seed) {
    const auto cases = exercise.cases(seed);
    JudgedExercise judged{.exercise = &exercise};
    // Before they are compared: some keep a state, and answer otherwise the second time.
    std::map<std::string, Verdict> verdicts;
    for (const auto& code : exercise.mistakes) verdicts[code.name] = verdict_on(exercise, cases, code.answer);
    for (const auto& codes : mistakes_of(exercise)) {
        auto& mistake = judged.mistakes.emplace_back(JudgedMistake{codes.front().hint, {}});
        for (const auto& code : codes) mistake.codes.push_back({code.name, verdicts.at(code.name)});
    }
    for (const auto& right : exercise.right) judged.right_passed += verdict_on(exercise, cases, right.answer).passed();
    return judged;
}

std::string in_words(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

bool is_caught(const JudgedCode& code) { return !code.verdict.passed(); }
bool is_told(const JudgedCode& code, const std::string& hint) { return is_caught(code) && code.verdict.hint == hint; }

std::string caught_words(const JudgedCode& code) {
    const auto& verdict = code.verdict;
    if (verdict.passed()) return "✗ passes";
    if (verdict.works_too_much()) return "✓ too much work";
    return fmt::format("✓ {} of {} cases wrong", verdict.total - verdict.right, verdict.total);
}

// Of how many codes something holds.
template <class Holds>
std::size_t count_codes(const JudgedExercise& one, const Holds& holds) {
    std::size_t count = 0;
    for (const auto& [hint, codes] : one.mistakes)
        for (const auto& code : codes) count += holds(code, hint);
    return count;
}

std::string of_all(std::size_t some, std::size_t all) {
    return fmt::format("{} {} of {}", some == all ? "✓" : "✗", some, all);
}

std::string summary_html(const std::vector<JudgedExercise>& all) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& one : all) {
        const auto codes = count_codes(one, [](const auto&, const auto&) { return true; });
        const auto caught = count_codes(one, [](const auto& code, const auto&) { return is_caught(code); });
        const auto twice =
            std::ranges::count_if(one.mistakes, [](const auto& mistake) { return mistake.codes.size() > 1; });
        const auto& folder = one.exercise->folder;
        const auto number = folder.substr(0, folder.find('_'));
        rows.push_back({"**" + number + "** " + in_words(folder.substr(number.size() + 1)),
                        std::to_string(one.mistakes.size()), std::to_string(twice), of_all(caught, codes),
                        of_all(count_codes(one, is_told), codes),
                        of_all(one.right_passed, one.exercise->right.size())});
    }
    return table_html({"Exercise", "Mistakes", "in two codes or more", "Codes that are caught",
                       "and told by the hint meant for them", "Right answers that pass"},
                      rows, "");
}

std::string hint_texts_html(const JudgedExercise& one) {
    const auto hints = read_hints(*one.exercise);
    std::string html = "<details><summary>What the hints say</summary>\n<dl>\n";
    std::set<std::string> ids;
    for (const auto& mistake : one.mistakes) ids.insert(mistake.hint);
    for (const auto& id : ids)
        if (const auto* text = hints.text(id))
            html += "<dt><code>" + escape_html(id) + "</code></dt><dd>" + escape_html(*text) + "</dd>\n";
    return html + "</dl></details>\n";
}

std::string exercise_html(const JudgedExercise& one) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [hint, codes] : one.mistakes)
        for (const auto& code : codes)
            rows.push_back(
                {(&code == &codes.front() ? "" : "↳ ") + in_words(code.name), caught_words(code),
                 fmt::format("{} `{}`", is_told(code, hint) ? "✓" : "✗", code.verdict.hint.value_or("none"))});
    return "<section id=\"" + one.exercise->folder + "\"><h2>" + in_words(one.exercise->folder) + "</h2>\n" +
           table_html({"Mistake (↳ in another code)", "Caught", "Hint"}, rows, "") + hint_texts_html(one) +
           "</section>\n";
}

}  // namespace

std::string mistakes_page(std::uint64_t seed, int threads) {
    const auto& all = exercises();
    std::vector<JudgedExercise> table(all.size());
    for_each_piece(all.size(), 1, threads, [&](std::size_t i, std::size_t) { table[i] = judged(all[i], seed); });
    std::string body =
        "<header>\n<p class=\"number\">raylab</p>\n<h1>Typical mistakes</h1>\n<p class=\"question\">Does the grader "
        "catch what it should, and say what is wrong? Every recorded mistake, and every right answer of another shape, "
        "judged for this page with the cases of seed " +
        std::to_string(seed) + ".</p>\n<ul class=\"contents\">";
    for (const auto& one : table)
        body += "<li><a href=\"#" + one.exercise->folder + "\">" + in_words(one.exercise->folder) + "</a></li>";
    body += "</ul></header>\n<main id=\"content\">\n" + summary_html(table);
    for (const auto& one : table) body += exercise_html(one);
    return whole_page({.title = "Typical mistakes · raylab lab book", .kind = "index"}, way_to_front_page("index.html"),
                      body + "</main>\n");
}

}  // namespace raylab

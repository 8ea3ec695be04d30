#include "raylab/report/page/formula.h"

#include "raylab/base/error.h"
#include "raylab/base/process.h"
#include "raylab/base/with_all_replaced.h"
#include "raylab/report/page/html.h"

#include <algorithm>
#include <map>

namespace raylab {

namespace {

constexpr double timeout = 20;  // seconds

// The text between two words of blahtexml's answer; empty where they are not there.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const auto from = text.find(begin);
    if (from == std::string::npos) return "";
    const auto start = from + begin.size();
    return text.substr(start, text.find(end, start) - start);
}

std::string without_newlines(std::string text) {
    std::erase(text, '\n');
    return text;
}

// blahtexml writes a hyphen, which browsers draw as the short stroke that it is.
std::string with_minus_signs(const std::string& markup) {
    return with_all_replaced(markup, ">-</mo>", ">&#x2212;</mo>");
}

std::string markup_of(const std::string& tex) {
    // Pages repeat their symbols; a program is run once for each formula.
    static thread_local std::map<std::string, std::string> known;
    if (const auto found = known.find(tex); found != known.end()) return found->second;
    static const auto program = find_program("blahtexml");
    if (program.empty()) return "<mtext>" + escape_html(tex) + "</mtext>";
    const auto result = run_process(program, {"--mathml"}, {.input = tex, .timeout = timeout});
    if (!result.succeeded()) throw Error("the formula " + tex + ": " + failure_of("blahtexml", result));
    if (const auto message = between(result.output, "<message>", "</message>"); !message.empty())
        throw Error("expected a formula that blahtexml can read, found " + tex + ": " + without_newlines(message));
    return known[tex] = with_minus_signs(without_newlines(between(result.output, "<markup>", "</markup>")));
}

// The marks: two characters of Unicode's private area around the formula's number.
constexpr std::string_view mark_begin = "\uE000", mark_end = "\uE001";

// Where the formula that begins with the dollar at `at` ends, as GitHub reads it: no blank inside its dollars, no digit
// after them, and neither code nor an empty line between them.
std::size_t end_of_formula(std::string_view text, std::size_t at) {
    const auto blank = [](char c) { return c == ' ' || c == '\n'; };
    if (at + 1 >= text.size() || blank(text[at + 1]) || text[at + 1] == '$') return std::string_view::npos;
    for (std::size_t i = at + 1; i < text.size(); ++i) {
        if (text[i] == '`' || text.substr(i).starts_with("\n\n")) break;
        const bool digit_after = i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
        if (text[i] == '$' && !blank(text[i - 1]) && text[i - 1] != '\\' && !digit_after) return i;
    }
    return std::string_view::npos;
}

// Just after the code span or fence that begins at `at` with backticks.
std::size_t end_of_code(std::string_view text, std::size_t at) {
    std::size_t ticks = at;
    while (ticks < text.size() && text[ticks] == '`') ++ticks;
    const auto mark = text.substr(at, ticks - at);
    for (std::size_t i = text.find(mark, ticks); i != std::string_view::npos; i = text.find(mark, i)) {
        const auto after = text.find_first_not_of('`', i);
        if ((after == std::string_view::npos ? text.size() : after) - i == mark.size()) return i + mark.size();
        i = after;
    }
    return ticks;
}

}  // namespace

std::string formula_html(std::string_view tex, FormulaPlace place) {
    return std::string("<math") + (place == FormulaPlace::displayed ? " display=\"block\">" : ">") +
           markup_of(std::string(tex)) + "</math>";
}

std::string equation_html(std::string_view tex) {
    const std::string text(tex);
    const auto number = between(text, "\\tag{", "}");
    const auto formula = formula_html(text.substr(0, text.find("\\tag{")), FormulaPlace::displayed);
    if (number.empty()) return "<div class=\"equation\">" + formula + "</div>\n";
    return "<div class=\"equation\" id=\"eq-" + anchor_name(number) + "\">" + formula + "<span class=\"tag\">(" +
           escape_html(number) + ")</span></div>\n";
}

// Browsers may break a line on either side of a formula, even before a full stop. So what opens a bracket before it,
// and what closes one or ends a sentence after it, is kept with it.
constexpr std::string_view opening = "([", closing = ".,;:!?)]'";

std::string InlineFormulas::take_from(std::string_view markdown) {
    std::string text;
    for (std::size_t at = 0; at < markdown.size();) {
        std::size_t end = at + 1;
        if (markdown[at] == '`') {
            end = end_of_code(markdown, at);
        } else if (markdown[at] == '$') {
            if (const auto close = end_of_formula(markdown, at); close != std::string_view::npos) {
                std::string tex(markdown.substr(at + 1, close - at - 1));
                std::ranges::replace(tex, '\n', ' ');
                text += std::string(mark_begin) + std::to_string(formulas_.size()) + std::string(mark_end);
                formulas_.push_back(tex);
                at = close + 1;
                continue;
            }
        }
        text += markdown.substr(at, end - at);
        at = end;
    }
    return text;
}

bool InlineFormulas::begins_with_formula(std::string_view text) { return text.starts_with(mark_begin); }

std::string InlineFormulas::put(std::string_view text, Form form) const {
    std::string whole;
    for (std::size_t at = 0;;) {
        const auto begin = text.find(mark_begin, at);
        whole += text.substr(at, begin - at);
        if (begin == std::string_view::npos) return whole;
        const auto number = begin + mark_begin.size(), end = text.find(mark_end, number);
        const auto& tex = formulas_.at(std::stoul(std::string(text.substr(number, end - number))));
        at = end + mark_end.size();
        if (form == Form::tex) {
            whole += tex;
            continue;
        }
        std::string close_by;
        while (!whole.empty() && opening.find(whole.back()) != std::string_view::npos) {
            close_by.insert(0, 1, whole.back());
            whole.pop_back();
        }
        close_by += formula_html(tex, FormulaPlace::in_line);
        const auto rest = std::min(text.find_first_not_of(closing, at), text.size());
        close_by += text.substr(at, rest - at);
        const bool alone = close_by.starts_with('<') && close_by.ends_with('>');
        whole += alone ? close_by : "<span class=\"unparted\">" + close_by + "</span>";
        at = rest;
    }
}

}  // namespace raylab

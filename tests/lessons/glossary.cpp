#include "glossary.h"

#include "raylab/base/small_letters.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <set>

namespace raylab::lessons {

namespace {

constexpr auto list_of_words = "Words and symbols";

// Parts whose bold words define nothing, or whose words are quoted.
bool is_aside(const Part& part) {
    return part.heading == list_of_words || part.heading == "Sources and further reading";
}

std::string in_one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

// The readable text of some of a lesson's parts as one string, for words that stand across the end of a line.
class RunningText {
public:
    template <class Wanted>
    RunningText(const LessonText& lesson, const Wanted& wanted) {
        for (const Part& part : lesson.parts) {
            if (!wanted(part)) continue;
            for (const Line& line : part.lines) {
                begins_.push_back({text_.size(), line.number});
                text_ += readable(line) + "\n";
            }
            text_ += "\n\n";
        }
    }

    const std::string& text() const { return text_; }
    int line_at(std::size_t place) const {
        int line = 0;
        for (const Begin& begin : begins_)
            if (begin.place <= place) line = begin.line;
        return line;
    }

private:
    struct Begin {
        std::size_t place;
        int line;
    };
    std::string text_;
    std::vector<Begin> begins_;
};

bool may_define(const Part& part) { return !is_aside(part) && part.heading != "Questions"; }
bool may_use(const Part& part) { return !is_aside(part); }

// The terms in bold in a lesson's text, with their lines.
struct Definition {
    std::string term;
    int line;
};
std::vector<Definition> definitions(const LessonText& lesson) {
    static const std::regex stars(R"(\*\*([^*]{1,80})\*\*)");
    std::vector<Definition> found;
    const RunningText text(lesson, may_define);
    for (auto match = std::sregex_iterator(text.text().begin(), text.text().end(), stars);
         match != std::sregex_iterator(); ++match)
        found.push_back({in_one_line(in_small_letters((*match)[1].str())),
                         text.line_at(static_cast<std::size_t>(match->position()))});
    return found;
}

// The last word of a term in the plural, as a pattern: shadow ray(s), boundary (boundaries).
std::regex use_of(const std::string& term) {
    static const std::regex special(R"([.^$|()\[\]{}*+?\\])");
    auto pattern = std::regex_replace(term, special, R"(\$&)");
    std::ranges::replace(pattern, '-', ' ');
    pattern = std::regex_replace(pattern, std::regex(" "), "[- \\n]+");
    return std::regex("(^|[^a-z0-9-])" + pattern + "(e?s)?([^a-z0-9-]|$)", std::regex::icase);
}

// The first line that uses a term, before a line of this number; a line that defines it counts from its bold word on.
std::optional<int> use_before(const LessonText& lesson, const std::regex& use, int end) {
    const RunningText text(lesson, may_use);
    std::smatch match;
    if (!std::regex_search(text.text(), match, use)) return std::nullopt;
    const int line = text.line_at(static_cast<std::size_t>(match.position() + match.length(1)));
    return line < end ? std::optional(line) : std::nullopt;
}

}  // namespace

std::vector<std::string> listed_terms(const LessonText& lesson) {
    std::vector<std::string> terms;
    if (const Part* part = lesson.part(list_of_words))
        for (const Line& line : part->lines)
            if (line.text.starts_with("- **"))
                if (const auto found = bold(line.text); !found.empty())
                    terms.push_back(in_small_letters(found.front()));
    return terms;
}

std::vector<std::string> listed_formulas(const LessonText& lesson) {
    std::vector<std::string> listed;
    if (const Part* part = lesson.part(list_of_words))
        for (const Line& line : part->lines)
            for (const auto& formula : formulas(line)) listed.push_back(formula);
    return listed;
}

std::vector<std::string> symbols(const std::string& formula) {
    static const std::regex words(R"(\\(text|mathrm|operatorname|tag|begin|end)\s*\{[^}]*\})");
    static const std::regex look(R"(\\(mathbf|hat|vec|overline|boldsymbol)\b)");
    static const std::regex index(R"([_](\{[^{}]*\}|\\[a-zA-Z]+|[^\\{]))");
    static const std::regex letter(R"(\\([a-zA-Z]+)|([a-zA-Z]))");
    static const std::set<std::string> greek{"alpha", "beta",  "gamma", "delta",  "epsilon", "varepsilon", "zeta",
                                             "eta",   "theta", "kappa", "lambda", "mu",      "nu",         "xi",
                                             "rho",   "sigma", "tau",   "phi",    "varphi",  "chi",        "psi",
                                             "omega", "Delta", "Gamma", "Omega",  "Phi",     "Sigma"};
    auto text = std::regex_replace(std::regex_replace(formula, words, " "), look, " ");
    text = std::regex_replace(text, index, " ");
    std::vector<std::string> found;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), letter); match != std::sregex_iterator();
         ++match) {
        const std::string command = (*match)[1], one = (*match)[2];
        if (!one.empty()) found.push_back(one);
        if (greek.contains(command)) found.push_back("\\" + command);
    }
    return found;
}

Complaints definition_complaints(const NamedLesson& lesson) {
    Complaints complaints;
    const auto listed = listed_terms(lesson.text);
    std::multiset<std::string> defined;
    for (const auto& [term, line] : definitions(lesson.text)) {
        defined.insert(term);
        if (std::ranges::find(listed, term) == listed.end())
            complaints.push_back(lesson.name + ", line " + std::to_string(line) + ": '" + term +
                                 "' is bold, and has no entry in '" + list_of_words + "'");
    }
    for (const auto& term : listed)
        if (const auto found = defined.count(term); found != 1)
            complaints.push_back(lesson.name + ": '" + term + "' has an entry, and is bold in the text " +
                                 std::to_string(found) + " times, not once");
    return complaints;
}

Complaints early_use_complaints(const std::vector<NamedLesson>& book) {
    Complaints complaints;
    for (std::size_t own = 0; own < book.size(); ++own)
        for (const auto& [term, line] : definitions(book[own].text)) {
            const auto use = use_of(term);
            for (std::size_t i = 0; i <= own; ++i) {
                const auto early = use_before(book[i].text, use, i == own ? line : 1 << 30);
                if (!early) continue;
                complaints.push_back(book[i].name + ", line " + std::to_string(*early) + ": uses '" + term +
                                     "', which " + book[own].name + " defines in line " + std::to_string(line));
                break;
            }
        }
    return complaints;
}

Complaints symbol_complaints(const std::vector<NamedLesson>& book) {
    std::set<std::string> known;
    for (const auto& lesson : book)
        for (const auto& formula : listed_formulas(lesson.text))
            for (const auto& symbol : symbols(formula)) known.insert(symbol);
    Complaints complaints;
    const NamedLesson& lesson = book.back();
    for (const Part& part : lesson.text.parts)
        for (const Line& line : part.lines)
            for (const auto& formula : formulas(line))
                for (const auto& symbol : symbols(formula))
                    if (known.insert(symbol).second)
                        complaints.push_back(lesson.name + ", line " + std::to_string(line.number) + ": '" + symbol +
                                             "' is in no list of symbols up to here");
    return complaints;
}

}  // namespace raylab::lessons

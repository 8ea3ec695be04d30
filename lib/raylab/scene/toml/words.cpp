#include "raylab/scene/toml/format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace raylab::toml_file {

namespace {

std::string range_in_words(const Number& number) {
    if (number.at_least && number.at_most) return fmt::format(" from {} to {}", *number.at_least, *number.at_most);
    std::vector<std::string> bounds;
    if (number.above) bounds.push_back(fmt::format("above {}", *number.above));
    if (number.at_least) bounds.push_back(fmt::format("of at least {}", *number.at_least));
    if (number.below) bounds.push_back(fmt::format("below {}", *number.below));
    if (number.at_most) bounds.push_back(fmt::format("of at most {}", *number.at_most));
    return bounds.empty() ? "" : fmt::format(" {}", fmt::join(bounds, " and "));
}

// "3", "at least 3", "1 to 64", or nothing.
std::string count_in_words(const List& list) {
    if (list.smallest == list.largest) return fmt::format("{}", list.smallest);
    if (list.largest != List{}.largest) return fmt::format("{} to {}", list.smallest, list.largest);
    return list.smallest > 0 ? fmt::format("at least {}", list.smallest) : "";
}

struct FormatInWords {
    std::string operator()(const Number& number) const { return "a number" + range_in_words(number); }
    std::string operator()(const Whole& whole) const {
        if (whole.smallest == whole.largest) return fmt::format("{}", whole.smallest);
        return fmt::format("a whole number from {} to {}", whole.smallest, whole.largest);
    }
    std::string operator()(const Text& text) const { return text.what + " in quotes"; }
    std::string operator()(const Word& word) const { return fmt::format("one of {}", fmt::join(word.words, ", ")); }
    std::string operator()(const List& list) const {
        const auto* number = std::get_if<Number>(&list.element->kind);
        const auto of = number ? "numbers" + range_in_words(*number) : in_words(*list.element);
        const auto count = count_in_words(list);
        if (!number) return fmt::format("an array{}, each {}", count.empty() ? "" : " of " + count, of);
        return fmt::format("an array of {}{}", count.empty() ? "" : count + " ", of);
    }
    std::string operator()(const Table& table) const { return "a table: " + table.what; }
    std::string operator()(const Tagged& tagged) const {
        std::vector<std::string> words;
        for (const auto& alternative : tagged.alternatives) words.push_back(alternative.word);
        return fmt::format("{} with {} ({})", tagged.what, tagged.tag, fmt::join(words, ", "));
    }
    std::string operator()(const Named& named) const { return "a table of " + named.what; }
    std::string operator()(const Either& either) const {
        std::vector<std::string> choices;
        for (const auto& choice : either.choices) choices.push_back(in_words(choice));
        return fmt::format("{}", fmt::join(choices, " or "));
    }
};

}  // namespace

std::string in_words(const Format& format) { return std::visit(FormatInWords{}, format.kind); }

}  // namespace raylab::toml_file

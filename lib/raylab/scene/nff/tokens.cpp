#include "raylab/scene/nff/tokens.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";
constexpr std::string_view number_begins = "0123456789+-.";

std::string in_quotes(std::string_view word) {
    constexpr std::size_t max_shown = 60;
    return '"' + std::string(word.substr(0, max_shown)) + '"';
}

// C's readers of the format accept a leading plus; from_chars, which is used because it ignores the locale, does not.
std::string_view without_plus(std::string_view word) {
    const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
    return has_plus ? word.substr(1) : word;
}

}  // namespace

NffTokens::NffTokens(std::string_view text, std::string file) : text_(text), file_(std::move(file)) { skip_to_word(); }

void NffTokens::skip_to_word() {
    for (; next_begin_ < text_.size(); ++next_begin_) {
        const char c = text_[next_begin_];
        if (c == '#') next_begin_ = std::min(text_.find('\n', next_begin_), text_.size() - 1);
        if (text_[next_begin_] == '\n') ++next_line_;
        if (c != '#' && blanks.find(c) == blanks.npos) return;
    }
}

std::string_view NffTokens::next_word() const {
    const auto end = text_.find_first_of(" \t\r\n\v\f#", next_begin_);
    return text_.substr(next_begin_, end - next_begin_);
}

bool NffTokens::number_follows() const {
    return !at_end() && number_begins.find(text_[next_begin_]) != number_begins.npos;
}

std::string_view NffTokens::word(const std::string& expected) {
    line_ = next_line_;
    if (at_end()) throw Error(place(), expected, "the end of the file");
    const auto result = next_word();
    next_begin_ += result.size();
    skip_to_word();
    return result;
}

double NffTokens::number(const std::string& expected) {
    const auto text = word(expected);
    const auto digits = without_plus(text);
    double value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size() || problem == std::errc::invalid_argument)
        throw Error(place(), expected + " (a number)", in_quotes(text));
    const bool fits = problem == std::errc{} && std::abs(value) <= std::numeric_limits<float>::max();
    if (!fits) throw Error(place(), expected + " (a number that fits a float)", in_quotes(text));
    return value;
}

double NffTokens::number_from(double smallest, double largest, const std::string& expected) {
    const double value = number(expected);
    if (value >= smallest && value <= largest) return value;
    const bool open = largest == std::numeric_limits<double>::infinity();
    const auto range = open ? fmt::format("at least {}", smallest) : fmt::format("from {} to {}", smallest, largest);
    throw Error(place(), fmt::format("{} ({})", expected, range), fmt::format("{}", value));
}

int NffTokens::whole(int smallest, int largest, const std::string& expected) {
    const auto text = word(expected);
    const auto digits = without_plus(text);
    int value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_whole = problem == std::errc{} && end == digits.data() + digits.size();
    if (is_whole && value >= smallest && value <= largest) return value;
    throw Error(place(), fmt::format("{} (a whole number from {} to {})", expected, smallest, largest),
                in_quotes(text));
}

Vec3d NffTokens::vector(const std::string& expected) {
    const double x = number(expected);
    const double y = number(expected);
    const double z = number(expected);
    return {x, y, z};
}

void NffTokens::expect_room_for(int count, std::size_t bytes, const std::string& things) const {
    const std::size_t room = (text_.size() - next_begin_ + 1) / bytes;  // no separator need follow the last one
    if (static_cast<std::size_t>(count) > room)
        throw Error(place(), fmt::format("{} {}", count, things), fmt::format("a file with room for {} at most", room));
}

}  // namespace raylab

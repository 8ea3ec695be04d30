#include "raylab/scene/mesh/text_lines.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace raylab {

namespace {

constexpr std::size_t longest_quote = 40;

// Joined lines have the backslash and the line's end between their parts, which count as blanks.
bool is_blank(char c, TextLayout::Backslash backslash) {
    return c == ' ' || (c >= '\t' && c <= '\r') || (c == '\\' && backslash == TextLayout::Backslash::joins_lines);
}

bool ends_line(char c) { return c == '\n' || c == '\r'; }

}  // namespace

std::string in_quotes(std::string_view word) {
    std::string text(word.substr(0, longest_quote));
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    return "'" + text + (word.size() > longest_quote ? "...'" : "'");
}

TextLines::TextLines(std::string_view bytes, std::string file, TextLayout layout)
    : bytes_(bytes), file_(std::move(file)), layout_(layout) {}

std::string_view TextLines::take_line() {
    const auto begin = next_;
    const bool joins = layout_.backslash == TextLayout::Backslash::joins_lines;
    line_ = next_line_;
    for (;;) {
        const auto end =
            static_cast<std::size_t>(std::ranges::find_if(bytes_.substr(next_), ends_line) - bytes_.begin());
        next_ = end + (bytes_.substr(end, 2) == "\r\n" ? 2 : end < bytes_.size() ? 1 : 0);
        ++next_line_;
        if (!joins || end == begin || bytes_[end - 1] != '\\' || next_ == bytes_.size())
            return bytes_.substr(begin, end - begin);
    }
}

void TextLines::split(std::string_view line) {
    if (layout_.comment != '\0') line = line.substr(0, line.find(layout_.comment));
    const auto blank = [this](char c) { return is_blank(c, layout_.backslash); };
    for (auto rest = std::ranges::find_if_not(line, blank); rest != line.end();) {
        const auto end = std::find_if(rest, line.end(), blank);
        words_.emplace_back(rest, end);
        rest = std::find_if_not(end, line.end(), blank);
    }
}

bool TextLines::next() {
    words_.clear();
    while (words_.empty() && next_ < bytes_.size()) split(take_line());
    return !words_.empty();
}

void TextLines::expect_next(std::string_view what) {
    if (!next()) throw Error(place(), std::string(what), "the end of the file");
}

void TextLines::expect_end() {
    if (next()) refuse("the end of the file");
}

float TextLines::number(std::size_t word) const {
    auto text = words_.at(word);
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    float value = 0;
    auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem == std::errc::result_out_of_range) {
        // from_chars reports numbers that are too small, too: their nearest float is a zero (that of a number that is
        // too large is infinity, refused below).
        double wide = 0;
        problem = std::from_chars(text.data(), text.data() + text.size(), wide).ec;
        value = cast<float>(wide);
    }
    if (problem != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        refuse("a finite number that fits a float", word);
    return value;
}

Vec3f TextLines::vector(std::size_t first_word) const {
    return {number(first_word), number(first_word + 1), number(first_word + 2)};
}

std::int64_t TextLines::integer(std::size_t word) const {
    const auto text = words_.at(word);
    std::int64_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc{} || end != text.data() + text.size()) refuse("an integer", word);
    return value;
}

void TextLines::refuse(const std::string& expected, std::size_t word) const {
    throw Error(place(), expected, in_quotes(words_.at(word)));
}

void TextLines::refuse_line(const std::string& expected) const {
    throw Error(place(), expected, in_quotes({words_.front().begin(), words_.back().end()}));
}

}  // namespace raylab

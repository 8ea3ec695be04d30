#include "raylab/scene/toml/skim.h"

#include "raylab/base/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::toml_file {

namespace {

constexpr int max_dots = 32;

// The memory that toml++'s nodes and the lab's own copy of them take together, measured as the largest resident set
// over 4 MiB of each: "[a]", "[[a]]", "[],", "{},"; "a = 0"; "0,"; and ".a" in a key.
constexpr double bytes_a_bracket = 352, bytes_a_pair = 384, bytes_an_element = 128, bytes_a_dot = 352;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// Scans TOML text and skips comments and strings.
class Skim {
public:
    Skim(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    void run() {
        if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (c == '"' || c == '\'') {
                pass_string(c);
            } else {
                look_at(c);
                ++at_;
            }
        }
    }

    double parsed_bytes() const { return parsed_bytes_ + static_cast<double>(text_.size()); }

private:
    void look_at(char c) {
        count(c);
        if (c == '\n') ++line_;
        if (c == '\n' || c == '=' || c == ',') dots_ = 0;
        if (c == '.' && ++dots_ > max_dots)
            throw Error({file_, line_}, fmt::format("at most {} dots in a row of names", max_dots), "more");
        if (static_cast<unsigned char>(c) >= 0x80)
            throw Error({file_, line_}, "ASCII outside quotes and comments", character());
    }

    // A dot belongs to a key before '=' and in a line "[a.b]"; elsewhere it belongs to a number. A line of an array's
    // numbers may be taken for such a line; then a few dots too many are counted.
    void count(char c) {
        if (c == '[' || c == '{') parsed_bytes_ += bytes_a_bracket;
        if (c == ',') parsed_bytes_ += bytes_an_element;
        if (c == '=') parsed_bytes_ += bytes_a_pair;
        if (c == '\n') begins_line_ = true;
        if (begins_line_ && c != '\n' && c != ' ') in_header_ = c == '[', begins_line_ = false;
        if (c == '=' || (c == ']' && in_header_)) parsed_bytes_ += dots_ * bytes_a_dot;
    }

    void pass_string(char quote) {
        const std::string triple(3, quote);
        if (text_.substr(at_, 3) != triple) return pass_to(std::string_view(triple).substr(0, 1), quote);
        at_ += 2;
        pass_to(triple, quote);
        // Up to two quotes may stand before the three that end the string.
        for (int i = 0; i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
    }

    // Skips from an opening quote to the end of what closes it; a string of one line ends with its line at the latest.
    void pass_to(std::string_view closing, char quote) {
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '\n') {
                if (closing.size() == 1) return;
                ++line_;
            }
            if (text_.substr(at_, closing.size()) == closing) {
                at_ += closing.size();
                return;
            }
            const bool is_escape = quote == '"' && text_[at_] == '\\';
            if (is_escape && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
        }
    }

    // The character as "U+00E4", so that a blank which is not ASCII can be told from one that is.
    std::string character() const {
        const auto byte = [&](std::size_t i) {
            return at_ + i < text_.size() ? static_cast<unsigned char>(text_[at_ + i]) : 0u;
        };
        const auto tail = [&](std::size_t i) { return byte(i) & 0x3fu; };
        if (byte(0) >> 5 == 0x6) return fmt::format("the character U+{:04X}", (byte(0) & 0x1fu) << 6 | tail(1));
        if (byte(0) >> 4 == 0xe)
            return fmt::format("the character U+{:04X}", (byte(0) & 0xfu) << 12 | tail(1) << 6 | tail(2));
        return fmt::format("the byte 0x{:02X}", byte(0));
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 1;
    int dots_ = 0;
    bool begins_line_ = true, in_header_ = false;
    double parsed_bytes_ = 0;
};

}  // namespace

void check_outside_strings(std::string_view text, const std::string& file) { Skim(text, file).run(); }

double parsed_bytes(std::string_view text, const std::string& file) {
    Skim skim(text, file);
    skim.run();
    return skim.parsed_bytes();
}

}  // namespace raylab::toml_file

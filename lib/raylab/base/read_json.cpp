#include "raylab/base/read_json.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace raylab {

using nlohmann::ordered_json;

namespace {

Place place_of(std::string_view text, std::size_t byte, const std::string& source) {
    const auto before = text.substr(0, byte);
    return {source, 1 + static_cast<int>(std::ranges::count(before, '\n')), "byte " + std::to_string(before.size())};
}

constexpr std::size_t max_bytes = std::size_t{1} << 28;

// The memory of nlohmann's values, measured as the largest resident set over 4 MiB of each: "[],"; "0,"; "\"\",";
// "\"a\":0,".
constexpr double bytes_a_bracket = 64, bytes_an_element = 48, bytes_a_string = 48, bytes_a_name = 144;

// Scans JSON text and skips strings. It throws an Error where the text is nested too deep or an object has too many
// names. Whether brackets match is checked by the parser.
class Skim {
public:
    Skim(std::string_view text, const std::string& source) : text_(text), source_(source) {}

    /// The most bytes that parsing takes.
    double bytes() {
        double bytes = static_cast<double>(text_.size()) + bytes_an_element;
        for (at_ = 0; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '"') pass_string(), bytes += bytes_a_string;
            if (c == '[' || c == '{') open(), bytes += bytes_a_bracket;
            if ((c == ']' || c == '}') && names_.size() > 1) names_.pop_back();
            if (c == ':') count_name(), bytes += bytes_a_name;
            if (c == ',') bytes += bytes_an_element;
        }
        return bytes;
    }

private:
    void pass_string() {
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
            if (text_[at_] == '\\') ++at_;
    }
    void open() {
        if (names_.size() > deepest_json)
            refuse(fmt::format("arrays and objects nested at most {} deep", deepest_json));
        names_.push_back(0);
    }
    void count_name() {
        if (++names_.back() > max_names) refuse(fmt::format("at most {} names in an object", max_names));
    }
    [[noreturn]] void refuse(const std::string& expected) const {
        throw Error(place_of(text_, at_, source_), expected, "more");
    }

    std::string_view text_;
    const std::string& source_;
    std::size_t at_ = 0;
    std::vector<std::size_t> names_{0};  // counted so far, of the text and of each array or object that is open
};

// The reason in nlohmann's message, after "[json.exception.parse_error.101] parse error at line 1, column 2: "; it may
// quote the whole text.
std::string reason(const ordered_json::exception& problem) {
    constexpr std::size_t longest = 120;
    const std::string said = problem.what();
    const auto colon = said.find(": ");
    const auto why = colon == said.npos ? said : said.substr(colon + 2);
    return why.size() > longest ? why.substr(0, longest) + "..." : why;
}

}  // namespace

ordered_json json_from_text(std::string_view text, const std::string& source, const MemoryLimit& limit) {
    check_memory({Skim(text, source).bytes(), "JSON", fmt::format("{} bytes of it, parsed", text.size())}, limit,
                 {source});
    try {
        return ordered_json::parse(text);
    } catch (const ordered_json::parse_error& problem) {
        throw Error(place_of(text, problem.byte, source), "JSON", reason(problem));
    } catch (const ordered_json::exception& problem) {
        throw Error({source}, "JSON whose numbers doubles can hold", reason(problem));
    }
}

ordered_json read_json(const std::filesystem::path& path, const MemoryLimit& limit) {
    return json_from_text(read_file(path, max_bytes), path.string(), limit);
}

}  // namespace raylab

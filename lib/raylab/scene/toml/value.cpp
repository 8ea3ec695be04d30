#include "raylab/scene/toml/value.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::toml_file {

namespace {

struct ValueInWords {
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(std::int64_t whole) const { return fmt::format("{}", whole); }
    std::string operator()(double number) const { return fmt::format("{}", number); }
    std::string operator()(const Value::Table&) const { return "a table"; }
    std::string operator()(const Value::Date&) const { return "a date or time"; }
    std::string operator()(const Value::Array& array) const {
        return array.empty() ? "an empty array" : fmt::format("an array of {}", array.size());
    }
    std::string operator()(const std::string& text) const {
        constexpr std::size_t max_shown = 60;  // bytes
        return text.size() <= max_shown ? '"' + text + '"' : fmt::format("a text of {} bytes", text.size());
    }
};

}  // namespace

const Entry* find(const Value::Table& table, std::string_view name) {
    const auto found = std::ranges::find(table, name, &Entry::name);
    return found == table.end() ? nullptr : &*found;
}

std::string in_words(const Value& value) { return std::visit(ValueInWords{}, value.data); }

}  // namespace raylab::toml_file

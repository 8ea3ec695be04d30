#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// The content of a TOML file, in types of our own: every value keeps its line, and toml++, which is slow to compile, is
// included by one file only.

namespace raylab::toml_file {

struct Entry;

struct Value {
    struct Date {};  // TOML has dates and times, which no scene uses
    using Array = std::vector<Value>;
    using Table = std::vector<Entry>;  // in the order of the file

    std::variant<bool, std::int64_t, double, std::string, Array, Table, Date> data;
    int line = 0;
};

/// One "name = value" of a table.
struct Entry {
    std::string name;
    Value value;
    int line = 0;
    int column = 0;
};

/// The entry of that name; null where there is none.
const Entry* find(const Value::Table& table, std::string_view name);

/// The value in the words of "found ...": `"red"`, `2.5`, `an array of 4`, `a table`.
std::string in_words(const Value& value);

/// Reads TOML text. It throws an Error, with file and line, for text that is not TOML.
Value parse(std::string_view text, const std::string& file);

}  // namespace raylab::toml_file

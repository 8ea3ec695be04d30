#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// What a TOML file holds, in types of our own: every value keeps its line, and toml++ (slow to compile) is seen by one
// file only.

namespace raylab::toml_file {

struct Entry;

struct Value {
    struct Date {};  // TOML has dates and times, scenes have none
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

/// The entry of that name; null: none.
const Entry* find(const Value::Table& table, std::string_view name);

/// What it is, for "found ...": `"red"`, `2.5`, `an array of 4`, `a table`.
std::string in_words(const Value& value);

/// Reads TOML text. Error, with file and line, for what is no TOML.
Value parse(std::string_view text, const std::string& file);

}  // namespace raylab::toml_file

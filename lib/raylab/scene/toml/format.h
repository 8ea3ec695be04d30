#pragma once

#include "raylab/scene/toml/value.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

// A file format described as a value: which keys a table has, what each may hold, which value stands for it where it is
// absent. The reader checks files against it, and suggestions and the JSON Schema are generated from it.

namespace raylab::toml_file {

struct Format;
struct Key;

enum class Stored { as_double, as_float };  // geometry is made of floats: a number that overflows one is refused

/// A finite number; whole numbers are numbers, too.
struct Number {
    std::optional<double> above = {}, at_least = {}, below = {}, at_most = {};
    Stored stored = Stored::as_double;
};

struct Whole {
    std::int64_t smallest, largest;
};

/// Any text except the empty one.
struct Text {
    std::string what;  // "a file", "the name of a material"
};

/// One of a few words.
struct Word {
    std::vector<std::string> words;
};

struct List {
    std::shared_ptr<const Format> element;
    std::size_t smallest = 0;
    std::size_t largest = std::numeric_limits<std::size_t>::max();
};

enum class Keys { any, exactly_one };  // of those described

struct Table {
    std::string what;  // "a sphere"
    std::vector<Key> keys;
    Keys given = Keys::any;
};

/// One of several tables. The word under `tag` chooses among them; where it is absent and `untagged` is set, the first
/// is meant.
struct Tagged {
    enum class Untagged { refused, first };
    std::string what;  // "a shape"
    std::string tag;   // "type"
    struct Alternative;
    std::vector<Alternative> alternatives;
    Untagged untagged = Untagged::refused;
};

/// A table whose keys are names that the author chooses.
struct Named {
    std::string what;  // "materials"
    std::shared_ptr<const Format> element;
};

/// Values of different kinds (a number, a text, an array, a table).
struct Either {
    std::vector<Format> choices;
};

struct Format {
    std::variant<Number, Whole, Text, Word, List, Table, Tagged, Named, Either> kind;
};

enum class Presence { required, optional };

struct Key {
    std::string name;
    Format format;
    std::string about;  // the unit and meaning, for the schema
    Presence presence = Presence::required;
    // The value of an absent optional key; without one, absence has a meaning of its own.
    std::optional<Value> fallback = {};
};

struct Tagged::Alternative {
    std::string word;
    Table table;
};

/// A value of that format in the words of "expected ...": "a number above 0".
std::string in_words(const Format& format);

/// Throws an Error unless the value is finite, complete, in range and has no keys that the format does not know, at
/// every depth. `name` is what messages call the value: "radius".
void check(const Value& value, const Format& format, const std::string& file, const std::string& name);

/// The key of that name; null where there is none.
const Key* find(const Table& table, std::string_view name);

/// The table that the value's tag chooses; the value must have passed check().
const Table& chosen(const Tagged& tagged, const Value& value);

/// The keys of each kind of table as Markdown, for people.
std::string reference(const Format& format);

/// A JSON Schema (draft 7) of the format.
std::string json_schema(const Format& format, const std::string& title);

}  // namespace raylab::toml_file

#pragma once

#include "raylab/base/error.h"
#include "raylab/geometry/vector.h"
#include "raylab/scene/toml/format.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raylab::toml_file {

/// A table that has passed check(): its values by key, or the format's fallback where one is absent. Asking for a key
/// that the format does not have, or for another kind of value, is a mistake of the program (an assertion).
class Node {
public:
    /// Keeps references to its arguments.
    Node(const Value& table, const Format& format, const std::string& file);

    bool has(std::string_view key) const;  // whether it is in the file
    double number(std::string_view key) const;
    int whole(std::string_view key) const;
    Vec3d vector(std::string_view key) const;
    const std::string& text(std::string_view key) const;
    const Value& value(std::string_view key) const;

    Node table(std::string_view key) const;
    std::vector<Node> tables(std::string_view key) const;  // empty where absent
    std::vector<std::pair<std::string, Node>> named(std::string_view key) const;
    /// The table of a Tagged key that may hold other kinds too; `key` must hold a table.
    Node choice(std::string_view key) const;

    std::string tag() const;  // the word that chose among the tables of a Tagged format
    Place place() const { return {*file_, value_->line}; }
    Place place(std::string_view key) const;
    const std::string& file() const { return *file_; }

private:
    const Key& described(std::string_view key) const;

    const Value* value_;
    const Format* format_;
    const Table* table_;
    const std::string* file_;
};

double number_of(const Value& value);
Vec3d vector_of(const Value& value);

}  // namespace raylab::toml_file

#pragma once

#include "raylab/base/error.h"
#include "raylab/scene/toml/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// One table of a TOML file other than a scene (hints, quizzes, courses), whose keys are asked for one after the other.
/// It refers to the value it was made of. Each function throws an Error with file and line for a key that holds
/// something else than `expected` says.
class TomlTable {
public:
    TomlTable(const toml_file::Value& value, const std::string& file) : value_(&value), file_(file) {
        if (!std::holds_alternative<toml_file::Value::Table>(value.data))
            throw Error({file_, value.line}, "a table", toml_file::in_words(value));
    }

    /// What the key holds; null where the key is absent.
    template <class T>
    const T* find(std::string_view key, const std::string& expected) const {
        const auto* found = entry(key);
        if (!found) return nullptr;
        if (const auto* value = std::get_if<T>(&found->value.data)) return value;
        fail(*found, expected);
    }

    /// A text that must be there.
    const std::string& text(std::string_view key) const { return needed<std::string>(key, "a text"); }

    /// A table within the table, which must be there.
    TomlTable table(std::string_view key) const {
        needed<toml_file::Value::Table>(key, "a table");
        return {entry(key)->value, file_};
    }

    /// The tables [[key]]; none where the key is absent.
    std::vector<TomlTable> tables(std::string_view key) const {
        std::vector<TomlTable> all;
        if (const auto* values = find<toml_file::Value::Array>(key, fmt::format("tables ([[{}]])", key)))
            for (const auto& value : *values) all.emplace_back(value, file_);
        return all;
    }

    /// The texts of an array; none where the key is absent.
    std::vector<std::string> texts(std::string_view key) const {
        std::vector<std::string> all;
        const auto* values = find<toml_file::Value::Array>(key, "an array of texts");
        if (!values) return all;
        for (const auto& value : *values) {
            const auto* text = std::get_if<std::string>(&value.data);
            if (!text) throw Error({file_, value.line}, fmt::format("texts in {}", key), toml_file::in_words(value));
            all.push_back(*text);
        }
        return all;
    }

    /// A number, written with or without a point.
    std::optional<double> number(std::string_view key, const std::string& expected) const {
        const auto* found = entry(key);
        if (!found) return std::nullopt;
        if (const auto* whole = std::get_if<std::int64_t>(&found->value.data)) return static_cast<double>(*whole);
        if (const auto* real = std::get_if<double>(&found->value.data)) return *real;
        fail(*found, expected);
    }

    /// A number from 0 to `most`.
    std::optional<double> number(std::string_view key, double most, const std::string& expected) const {
        const auto value = number(key, expected);
        if (value && !(*value >= 0 && *value <= most)) fail(*entry(key), expected);
        return value;
    }

    /// The names of all its keys, in the order of the file.
    std::vector<std::string> keys() const {
        std::vector<std::string> all;
        for (const auto& entry : entries()) all.push_back(entry.name);
        return all;
    }

    void knows_only(std::initializer_list<std::string_view> keys) const {
        for (const auto& entry : entries())
            if (std::ranges::find(keys, entry.name) == keys.end())
                throw Error({file_, entry.line}, fmt::format("one of the keys {}", fmt::join(keys, ", ")), entry.name);
    }

    /// Where the key stands, or the table that lacks it.
    Place place(std::string_view key) const {
        const auto* found = entry(key);
        return {file_, found ? found->line : value_->line};
    }

    /// Refuses what the key holds, or that it is absent.
    [[noreturn]] void fail(std::string_view key, const std::string& expected) const {
        if (const auto* found = entry(key)) fail(*found, expected);
        throw Error({file_, value_->line}, fmt::format("{} '{}'", expected, key), "none");
    }

private:
    const toml_file::Value::Table& entries() const { return std::get<toml_file::Value::Table>(value_->data); }

    const toml_file::Entry* entry(std::string_view key) const { return toml_file::find(entries(), key); }

    template <class T>
    const T& needed(std::string_view key, const std::string& expected) const {
        if (const auto* value = find<T>(key, expected)) return *value;
        fail(key, expected);
    }

    [[noreturn]] void fail(const toml_file::Entry& entry, const std::string& expected) const {
        throw Error({file_, entry.line}, entry.name + " to be " + expected, toml_file::in_words(entry.value));
    }

    const toml_file::Value* value_;
    std::string file_;
};

}  // namespace raylab

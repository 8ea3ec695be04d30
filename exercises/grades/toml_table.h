#pragma once

#include "raylab/base/error.h"
#include "raylab/scene/toml/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace raylab::grading {

/// One table of a TOML file, whose keys are asked for one after the other. Errors name file and line.
class TomlTable {
public:
    TomlTable(const toml_file::Value& value, const std::string& file)
        : table_(std::get<toml_file::Value::Table>(value.data)), file_(file) {}

    template <class T>
    std::optional<T> find(const std::string& name, const std::string& expected) const {
        const auto* entry = toml_file::find(table_, name);
        if (!entry) return std::nullopt;
        if (const auto* value = std::get_if<T>(&entry->value.data)) return *value;
        fail(*entry, expected);
    }

    /// A number from 0 to `most`, written with or without a point.
    std::optional<double> number(const std::string& name, double most, const std::string& expected) const {
        const auto* entry = toml_file::find(table_, name);
        if (!entry) return std::nullopt;
        const auto* whole = std::get_if<std::int64_t>(&entry->value.data);
        const auto* real = std::get_if<double>(&entry->value.data);
        const double value = whole ? static_cast<double>(*whole) : real ? *real : -1;
        if (!(value >= 0 && value <= most)) fail(*entry, expected);
        return value;
    }

    void knows_only(std::initializer_list<std::string_view> names) const {
        for (const auto& entry : table_)
            if (std::ranges::find(names, entry.name) == names.end())
                throw Error({file_, entry.line}, fmt::format("one of the keys {}", fmt::join(names, ", ")), entry.name);
    }

    [[noreturn]] void fail(const toml_file::Entry& entry, const std::string& expected) const {
        throw Error({file_, entry.line}, entry.name + " to be " + expected, toml_file::in_words(entry.value));
    }

    const toml_file::Entry* entry(const std::string& name) const { return toml_file::find(table_, name); }

private:
    const toml_file::Value::Table& table_;
    std::string file_;
};

}  // namespace raylab::grading

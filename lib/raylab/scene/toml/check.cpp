#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"
#include "raylab/number/scalar.h"
#include "raylab/scene/toml/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::toml_file {

namespace {

// Halfway from the largest float to where the next would be; from here on rounding gives infinity.
constexpr double overflows_float = 0x1.ffffffp127;

// NaN fails every comparison, so the comparisons are written positively.
bool in_range(double x, const Number& format) {
    if (!std::isfinite(x)) return false;
    if (format.above && !(x > *format.above)) return false;
    if (format.at_least && !(x >= *format.at_least)) return false;
    if (format.below && !(x < *format.below)) return false;
    return !format.at_most || x <= *format.at_most;
}

// A positive size so small that it is rounded to the float 0 does not fit either.
bool fits(double x, const Number& format) {
    if (format.stored == Stored::as_double) return true;
    return std::abs(x) < overflows_float && (!format.above || cast<float>(x) > *format.above);
}

std::vector<std::string> names_of(const Table& table) {
    std::vector<std::string> names;
    for (const auto& key : table.keys) names.push_back(key.name);
    return names;
}

std::vector<std::string> words_of(const Tagged& tagged) {
    std::vector<std::string> words;
    for (const auto& alternative : tagged.alternatives) words.push_back(alternative.word);
    return words;
}

// Checks one value against any kind of format; `where` names the value in messages.
class Check {
public:
    Check(const std::string& file, const Value& value, const std::string& name)
        : file_(file), value_(value), name_(name) {}

    void operator()(const Number& format) const {
        const auto* whole = std::get_if<std::int64_t>(&value_.data);
        const auto* number = std::get_if<double>(&value_.data);
        if (!whole && !number) refuse(in_words(Format{format}));
        const double x = whole ? static_cast<double>(*whole) : *number;
        if (!in_range(x, format)) refuse(in_words(Format{format}));
        if (!fits(x, format)) refuse(in_words(Format{format}) + " that fits a float");
    }

    void operator()(const Whole& format) const {
        const auto* whole = std::get_if<std::int64_t>(&value_.data);
        if (!whole || *whole < format.smallest || *whole > format.largest) refuse(in_words(Format{format}));
    }

    void operator()(const Text& format) const {
        const auto* text = std::get_if<std::string>(&value_.data);
        if (!text || text->empty()) refuse(in_words(Format{format}));
    }

    void operator()(const Word& format) const {
        const auto* text = std::get_if<std::string>(&value_.data);
        if (!text) refuse(in_words(Format{format}));
        if (std::ranges::find(format.words, *text) == format.words.end())
            refuse(in_words(Format{format}), with_suggestion(*text, format.words));
    }

    void operator()(const List& format) const {
        const auto* array = std::get_if<Value::Array>(&value_.data);
        if (!array || array->size() < format.smallest || array->size() > format.largest)
            refuse(in_words(Format{format}));
        for (std::size_t i = 0; i < array->size(); ++i)
            check((*array)[i], *format.element, file_, fmt::format("{}[{}]", name_, i));
    }

    void operator()(const Table& format) const {
        const auto* table = std::get_if<Value::Table>(&value_.data);
        if (!table) refuse(in_words(Format{format}));
        check_keys(*table, format);
        for (const auto& entry : *table) check(entry.value, find(format, entry.name)->format, file_, entry.name);
    }

    void operator()(const Tagged& format) const {
        const auto* table = std::get_if<Value::Table>(&value_.data);
        if (!table) refuse(in_words(Format{format}));
        const auto* tag = find(*table, format.tag);
        if (!tag && format.untagged == Tagged::Untagged::refused) refuse(in_words(Format{format}), "none");
        if (tag)
            check(tag->value, Format{Word{words_of(format)}}, file_, fmt::format("{} of {}", format.tag, format.what));
        (*this)(chosen(format, value_));
    }

    void operator()(const Named& format) const {
        const auto* table = std::get_if<Value::Table>(&value_.data);
        if (!table) refuse(in_words(Format{format}));
        for (const auto& entry : *table)
            check(entry.value, *format.element, file_, fmt::format("{}.{}", name_, entry.name));
    }

    void operator()(const Either& format) const {
        for (const auto& choice : format.choices)
            if (same_kind(choice)) return check(value_, choice, file_, name_);
        refuse(in_words(Format{format}));
    }

private:
    void check_keys(const Value::Table& table, const Table& format) const {
        for (const auto& entry : table)
            if (!find(format, entry.name))
                throw Error({file_, entry.line},
                            fmt::format("a key of {} ({})", format.what, fmt::join(names_of(format), ", ")),
                            with_suggestion(entry.name, names_of(format)));
        for (const auto& key : format.keys)
            if (key.presence == Presence::required && !find(table, key.name))
                throw Error({file_, value_.line},
                            fmt::format("{} with {} ({})", format.what, key.name, in_words(key.format)), "none");
        if (format.given == Keys::exactly_one && table.size() != 1)
            throw Error({file_, value_.line}, fmt::format("one of {} in each table", fmt::join(names_of(format), ", ")),
                        fmt::format("{}", table.size()));
    }

    bool same_kind(const Format& format) const {
        const auto& kind = format.kind;
        if (std::holds_alternative<Value::Table>(value_.data))
            return std::holds_alternative<Table>(kind) || std::holds_alternative<Tagged>(kind);
        if (std::holds_alternative<Value::Array>(value_.data)) return std::holds_alternative<List>(kind);
        if (std::holds_alternative<std::string>(value_.data)) return std::holds_alternative<Text>(kind);
        return std::holds_alternative<Number>(kind);
    }

    [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
        throw Error({file_, value_.line}, fmt::format("{} for {}", expected, name_), found);
    }
    [[noreturn]] void refuse(const std::string& expected) const { refuse(expected, in_words(value_)); }

    const std::string& file_;
    const Value& value_;
    const std::string& name_;
};

}  // namespace

void check(const Value& value, const Format& format, const std::string& file, const std::string& name) {
    std::visit(Check(file, value, name), format.kind);
}

const Key* find(const Table& table, std::string_view name) {
    const auto found = std::ranges::find(table.keys, name, &Key::name);
    return found == table.keys.end() ? nullptr : &*found;
}

const Table& chosen(const Tagged& tagged, const Value& value) {
    const auto* tag = find(std::get<Value::Table>(value.data), tagged.tag);
    if (!tag) return tagged.alternatives.front().table;
    return std::ranges::find(tagged.alternatives, std::get<std::string>(tag->value.data), &Tagged::Alternative::word)
        ->table;
}

}  // namespace raylab::toml_file

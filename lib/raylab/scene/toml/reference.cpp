#include "raylab/scene/toml/format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace raylab::toml_file {

namespace {

std::string in_toml(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value.data)) return '"' + *text + '"';
    const auto* array = std::get_if<Value::Array>(&value.data);
    if (!array) return in_words(value);
    std::vector<std::string> elements;
    for (const auto& element : *array) elements.push_back(in_toml(element));
    return fmt::format("[{}]", fmt::join(elements, ", "));
}

std::string absence(const Key& key) {
    if (key.presence == Presence::required) return "required";
    return key.fallback ? '`' + in_toml(*key.fallback) + '`' : "";
}

std::string row(const Key& key) {
    return fmt::format("| `{}` | {} | {} | {} |\n", key.name, in_words(key.format), absence(key), key.about);
}

std::string heading(const std::string& what) {
    return fmt::format("\n### {}\n\n| key | value | if absent | meaning |\n|---|---|---|---|\n", what);
}

// One section for each kind of table, in the order in which they are first mentioned.
class Reference {
public:
    std::string text;

    void add(const Format& format) {
        if (const auto* list = std::get_if<List>(&format.kind)) add(*list->element);
        if (const auto* named = std::get_if<Named>(&format.kind)) add(*named->element);
        if (const auto* table = std::get_if<Table>(&format.kind)) add(*table);
        if (const auto* tagged = std::get_if<Tagged>(&format.kind)) add(*tagged);
        if (const auto* either = std::get_if<Either>(&format.kind))
            for (const auto& choice : either->choices) add(choice);
    }

private:
    void add(const Table& table) {
        if (!known_.insert(table.what).second) return;
        text += heading(table.what + (table.given == Keys::exactly_one ? ": exactly one of" : ""));
        for (const auto& key : table.keys) text += row(key);
        for (const auto& key : table.keys) add(key.format);
    }

    // Keys that all alternatives share are listed once.
    void add(const Tagged& tagged) {
        if (!known_.insert(tagged.what).second) return;
        const auto& first = tagged.alternatives.front().table;
        const auto is_shared = [&](const Key& key) {
            return tagged.alternatives.size() > 1 && key.name != tagged.tag &&
                   std::ranges::all_of(tagged.alternatives, [&](const auto& other) {
                       const auto* same = find(other.table, key.name);
                       return same && same->about == key.about;
                   });
        };
        if (std::ranges::any_of(first.keys, is_shared)) {
            text += heading(tagged.what + ", whatever its " + tagged.tag);
            for (const auto& key : first.keys)
                if (is_shared(key)) text += row(key);
        }
        for (const auto& alternative : tagged.alternatives) {
            text += heading(fmt::format("{}: `{} = \"{}\"`", alternative.table.what, tagged.tag, alternative.word));
            for (const auto& key : alternative.table.keys)
                if (key.name != tagged.tag && !is_shared(key)) text += row(key);
        }
        for (const auto& alternative : tagged.alternatives)
            for (const auto& key : alternative.table.keys) add(key.format);
    }

    std::set<std::string> known_;
};

}  // namespace

std::string reference(const Format& format) {
    Reference result;
    result.add(format);
    return result.text;
}

}  // namespace raylab::toml_file

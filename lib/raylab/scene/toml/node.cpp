#include "raylab/scene/toml/node.h"

#include <algorithm>
#include <cassert>

namespace raylab::toml_file {

namespace {

const Table& table_of(const Format& format, const Value& value) {
    if (const auto* tagged = std::get_if<Tagged>(&format.kind)) return chosen(*tagged, value);
    return std::get<Table>(format.kind);
}

bool holds_table(const Format& format) {
    return std::holds_alternative<Table>(format.kind) || std::holds_alternative<Tagged>(format.kind);
}

}  // namespace

Node::Node(const Value& table, const Format& format, const std::string& file)
    : value_(&table), format_(&format), table_(&table_of(format, table)), file_(&file) {}

const Key& Node::described(std::string_view key) const {
    const auto* found = find(*table_, key);
    assert(found && "the format describes every key that is read");
    return *found;
}

bool Node::has(std::string_view key) const {
    described(key);
    return find(std::get<Value::Table>(value_->data), key) != nullptr;
}

const Value& Node::value(std::string_view key) const {
    if (const auto* entry = find(std::get<Value::Table>(value_->data), key)) return entry->value;
    const auto& fallback = described(key).fallback;
    assert(fallback && "an absent key without a fallback is asked for with has() first");
    return *fallback;
}

double Node::number(std::string_view key) const { return number_of(value(key)); }
int Node::whole(std::string_view key) const { return static_cast<int>(std::get<std::int64_t>(value(key).data)); }
Vec3d Node::vector(std::string_view key) const { return vector_of(value(key)); }
const std::string& Node::text(std::string_view key) const { return std::get<std::string>(value(key).data); }

Node Node::table(std::string_view key) const { return {value(key), described(key).format, *file_}; }

std::vector<Node> Node::tables(std::string_view key) const {
    std::vector<Node> result;
    if (!has(key)) return result;
    const auto& element = *std::get<List>(described(key).format.kind).element;
    for (const auto& each : std::get<Value::Array>(value(key).data)) result.emplace_back(each, element, *file_);
    return result;
}

std::vector<std::pair<std::string, Node>> Node::named(std::string_view key) const {
    std::vector<std::pair<std::string, Node>> result;
    if (!has(key)) return result;
    const auto& element = *std::get<Named>(described(key).format.kind).element;
    for (const auto& entry : std::get<Value::Table>(value(key).data))
        result.emplace_back(entry.name, Node(entry.value, element, *file_));
    return result;
}

Node Node::choice(std::string_view key) const {
    const auto& choices = std::get<Either>(described(key).format.kind).choices;
    const auto choice = std::ranges::find_if(choices, holds_table);
    assert(choice != choices.end() && "one of the choices is a table");
    return {value(key), *choice, *file_};
}

std::string Node::tag() const {
    const auto& tagged = std::get<Tagged>(format_->kind);
    const auto* entry = find(std::get<Value::Table>(value_->data), tagged.tag);
    return entry ? std::get<std::string>(entry->value.data) : tagged.alternatives.front().word;
}

Place Node::place(std::string_view key) const { return has(key) ? Place{*file_, value(key).line} : place(); }

double number_of(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole);
    return std::get<double>(value.data);
}

Vec3d vector_of(const Value& value) {
    const auto& array = std::get<Value::Array>(value.data);
    return {number_of(array.at(0)), number_of(array.at(1)), number_of(array.at(2))};
}

}  // namespace raylab::toml_file

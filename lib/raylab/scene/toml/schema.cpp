#include "raylab/scene/toml/format.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace raylab::toml_file {

namespace {

using Json = nlohmann::ordered_json;  // keys in the order of the format

constexpr double largest_float = std::numeric_limits<float>::max();

Json json(const Value& value);

struct ToJson {
    Json operator()(bool flag) const { return flag; }
    Json operator()(std::int64_t whole) const { return whole; }
    Json operator()(double number) const { return number; }
    Json operator()(const std::string& text) const { return text; }
    Json operator()(const Value::Date&) const { return nullptr; }
    Json operator()(const Value::Array& array) const {
        Json result = Json::array();
        for (const auto& element : array) result.push_back(json(element));
        return result;
    }
    Json operator()(const Value::Table& table) const {
        Json result = Json::object();
        for (const auto& entry : table) result[entry.name] = json(entry.value);
        return result;
    }
};

Json json(const Value& value) { return std::visit(ToJson{}, value.data); }

// Each kind of table becomes a definition with a name, to which $ref refers.
class Schema {
public:
    Json operator()(const Format& format) { return std::visit(*this, format.kind); }

    Json operator()(const Number& number) {
        Json result{{"type", "number"}};
        if (number.above) result["exclusiveMinimum"] = *number.above;
        if (number.at_least) result["minimum"] = *number.at_least;
        if (number.below) result["exclusiveMaximum"] = *number.below;
        if (number.at_most) result["maximum"] = *number.at_most;
        if (number.stored == Stored::as_double) return result;
        if (!number.above && !number.at_least) result["minimum"] = -largest_float;
        if (!number.below && !number.at_most) result["maximum"] = largest_float;
        return result;
    }

    Json operator()(const Whole& whole) {
        return {{"type", "integer"}, {"minimum", whole.smallest}, {"maximum", whole.largest}};
    }

    Json operator()(const Text&) { return {{"type", "string"}, {"minLength", 1}}; }

    Json operator()(const Word& word) {
        if (word.words.size() == 1) return {{"const", word.words.front()}};
        return {{"enum", word.words}};
    }

    Json operator()(const List& list) {
        Json result{{"type", "array"}, {"items", (*this)(*list.element)}};
        if (list.smallest > 0) result["minItems"] = list.smallest;
        if (list.largest != List{}.largest) result["maxItems"] = list.largest;
        return result;
    }

    Json operator()(const Table& table) { return reference(table.what, object(table)); }

    Json operator()(const Tagged& tagged) {
        Json choices = Json::array();
        for (const auto& alternative : tagged.alternatives) {
            Json table = object(alternative.table);
            const bool is_first = &alternative == &tagged.alternatives.front();
            if (!is_first || tagged.untagged == Tagged::Untagged::refused) table["required"].push_back(tagged.tag);
            choices.push_back(reference(alternative.table.what, table));
        }
        return reference(tagged.what, {{"type", "object"}, {"oneOf", choices}});
    }

    Json operator()(const Named& named) {
        return {{"type", "object"}, {"additionalProperties", (*this)(*named.element)}};
    }

    Json operator()(const Either& either) {
        Json choices = Json::array();
        for (const auto& choice : either.choices) choices.push_back((*this)(choice));
        return {{"anyOf", choices}};
    }

    Json object(const Table& table) {
        Json result{{"type", "object"}, {"description", table.what}, {"additionalProperties", false}};
        result["properties"] = Json::object();
        for (const auto& key : table.keys) {
            Json& property = result["properties"][key.name] = described(key);
            if (key.fallback) property["default"] = json(*key.fallback);
            if (key.presence == Presence::required) result["required"].push_back(key.name);
        }
        if (table.given == Keys::exactly_one) result["minProperties"] = result["maxProperties"] = 1;
        return result;
    }

    const Json& definitions() const { return definitions_; }

private:
    // In draft 7 everything beside a $ref is ignored, so the reference is wrapped to keep the description.
    Json described(const Key& key) {
        Json value = (*this)(key.format);
        Json result{{"description", key.about}};
        if (value.contains("$ref"))
            result["allOf"] = Json::array({value});  // {value} alone is an array to one compiler and a copy to another
        else
            result.update(value);
        return result;
    }

    Json reference(const std::string& what, const Json& definition) {
        auto name = what.substr(what.find(' ') + 1);  // without its article
        std::ranges::replace(name, ' ', '_');
        if (definitions_.contains(name) && definitions_[name] != definition)
            throw std::logic_error("two formats: " + name);
        definitions_[name] = definition;
        return {{"$ref", "#/definitions/" + name}};
    }

    Json definitions_ = Json::object();
};

}  // namespace

std::string json_schema(const Format& format, const std::string& title) {
    Schema schema;
    Json result{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
    result.update(schema.object(std::get<Table>(format.kind)));
    result["definitions"] = schema.definitions();
    return result.dump(2) + '\n';
}

}  // namespace raylab::toml_file

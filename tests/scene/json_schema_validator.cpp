#include "scene/json_schema_validator.h"

#include <algorithm>
#include <set>
#include <stdexcept>

using nlohmann::json;

namespace {

bool has_type(const json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    throw std::logic_error("unknown type " + type);
}

}  // namespace

bool JsonSchemaValidator::accepts(const json& schema, const json& value) const {
    return std::ranges::all_of(schema.items(), [&](const auto& each) { return obeys(each.key(), schema, value); });
}

bool JsonSchemaValidator::obeys(const std::string& keyword, const json& schema, const json& value) const {
    static const std::set<std::string> notes{"$schema", "title", "description", "default", "definitions"};
    const json& rule = schema.at(keyword);
    if (notes.contains(keyword)) return true;
    if (keyword == "$ref") return accepts(root_.at(json::json_pointer(rule.get<std::string>().substr(1))), value);
    if (keyword == "type") return has_type(value, rule);
    if (keyword == "const") return value == rule;
    if (keyword == "enum") return std::ranges::find(rule, value) != rule.end();
    if (keyword == "oneOf") return accepting(rule, value) == 1;
    if (keyword == "anyOf") return accepting(rule, value) > 0;
    if (keyword == "allOf") return accepting(rule, value) == rule.size();
    if (keyword == "minimum") return !value.is_number() || value >= rule;
    if (keyword == "maximum") return !value.is_number() || value <= rule;
    if (keyword == "exclusiveMinimum") return !value.is_number() || value > rule;
    if (keyword == "exclusiveMaximum") return !value.is_number() || value < rule;
    if (keyword == "minLength") return !value.is_string() || value.get_ref<const std::string&>().size() >= rule;
    if (keyword == "minItems") return !value.is_array() || value.size() >= rule;
    if (keyword == "maxItems") return !value.is_array() || value.size() <= rule;
    if (keyword == "minProperties") return !value.is_object() || value.size() >= rule;
    if (keyword == "maxProperties") return !value.is_object() || value.size() <= rule;
    if (keyword == "items")
        return !value.is_array() || std::ranges::all_of(value, [&](const json& each) { return accepts(rule, each); });
    if (keyword == "required")
        return !value.is_object() || std::ranges::all_of(rule, [&](const json& key) { return value.contains(key); });
    if (keyword == "properties" || keyword == "additionalProperties") return knows_all(schema, value);
    throw std::logic_error("unknown keyword " + keyword);
}

bool JsonSchemaValidator::knows_all(const json& schema, const json& object) const {
    if (!object.is_object()) return true;
    const json none = json::object();
    const json& known = schema.contains("properties") ? schema.at("properties") : none;
    const json& others = schema.at("additionalProperties");
    return std::ranges::all_of(object.items(), [&](const auto& each) {
        if (known.contains(each.key())) return accepts(known.at(each.key()), each.value());
        return others.is_object() && accepts(others, each.value());
    });
}

std::size_t JsonSchemaValidator::accepting(const json& schemas, const json& value) const {
    const auto count = std::ranges::count_if(schemas, [&](const json& each) { return accepts(each, value); });
    return static_cast<std::size_t>(count);
}

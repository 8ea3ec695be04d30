#pragma once

#include <nlohmann/json.hpp>

/// Validates a JSON value by the part of JSON Schema (draft 7) that the scene schema uses. An unknown keyword fails the
/// running test, because a validator that ignores keywords would prove nothing.
class JsonSchemaValidator {
public:
    explicit JsonSchemaValidator(nlohmann::json schema) : root_(std::move(schema)) {}
    bool accepts(const nlohmann::json& value) const { return accepts(root_, value); }

private:
    bool accepts(const nlohmann::json& schema, const nlohmann::json& value) const;
    bool obeys(const std::string& keyword, const nlohmann::json& schema, const nlohmann::json& value) const;
    bool knows_all(const nlohmann::json& schema, const nlohmann::json& object) const;
    std::size_t accepting(const nlohmann::json& schemas, const nlohmann::json& value) const;

    nlohmann::json root_;
};

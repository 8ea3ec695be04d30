#pragma once

#include "raylab/base/error.h"
#include "raylab/scene/scene.h"

#include <nlohmann/json.hpp>
#include <string>

// The parts of a replay file. Floats are written as decimals of the doubles that they are, so that they are read back
// unchanged; a value for which JSON has no number is a word: "infinity", "-infinity".

namespace raylab::replay {

nlohmann::ordered_json json_of(float number);
nlohmann::ordered_json json_of(const Vec3f& vector);
nlohmann::ordered_json json_of(const Object& object);

/// A value in a file, with its place, which an Error names where the value is not as expected.
class Value {
public:
    Value(const nlohmann::ordered_json& json, std::string file, std::string pointer)
        : json_(&json), file_(std::move(file)), pointer_(std::move(pointer)) {}

    bool has(const std::string& name) const { return json_->is_object() && json_->contains(name); }
    Value at(const std::string& name) const;
    Value at(std::size_t index) const;
    std::size_t size() const;
    float number() const;  // a finite number
    double exact_number() const;
    float number_or_infinity() const;
    std::uint32_t whole() const;
    std::string text() const;
    Vec3f vector() const;
    Place place() const { return {file_, 0, pointer_}; }
    [[noreturn]] void refuse(const std::string& expected) const;

private:
    const nlohmann::ordered_json* json_;
    std::string file_, pointer_;
};

Object object_of(const Value& value);

}  // namespace raylab::replay

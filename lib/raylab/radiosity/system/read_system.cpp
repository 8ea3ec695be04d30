#include "raylab/radiosity/system/read_system.h"

#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"
#include "raylab/base/read_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace raylab {

namespace {

using nlohmann::ordered_json;

const std::array<std::string, 4> fields{"area", "emission", "reflectance", "F"};

// A value of the JSON text and its place.
struct Value {
    const ordered_json& json;
    const std::string& source;
    std::string pointer;

    [[noreturn]] void refuse(const std::string& expected) const {
        const std::string found = json.is_structured()
                                      ? fmt::format("an {} of {}", json.type_name(), json.size())
                                      : json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
        throw Error({source, 0, pointer}, expected, found.size() > 60 ? found.substr(0, 60) + "..." : found);
    }
    Value at(std::size_t index) const { return {json[index], source, fmt::format("{}/{}", pointer, index)}; }
    void check_size(std::size_t size, const std::string& of_what) const {
        if (!json.is_array() || json.size() != size) refuse(fmt::format("an array of {} {}", size, of_what));
    }
    double number(const std::string& expected, const std::function<bool(double)>& is_good) const {
        if (!json.is_number() || !is_good(json.get<double>())) refuse(expected);
        return json.get<double>();
    }
    // A number stands for three equal channels.
    Color color(const std::string& expected, const std::function<bool(double)>& is_good) const {
        if (!json.is_array()) return Color(number(expected, is_good));
        check_size(3, "channels, or one number");
        return {at(0).number(expected, is_good), at(1).number(expected, is_good), at(2).number(expected, is_good)};
    }
};

bool is_reflectance(double x) { return x >= 0 && x < 1; }
bool is_not_negative(double x) { return x >= 0 && std::isfinite(x); }
bool is_area(double x) { return x > 0 && std::isfinite(x); }

Value field(const ordered_json& json, const std::string& source, const std::string& name) {
    if (!json.contains(name)) throw Error({source}, fmt::format("a field \"{}\"", name), "none");
    return {json[name], source, "/" + name};
}

void check_fields(const ordered_json& json, const std::string& source) {
    if (!json.is_object())
        throw Error({source}, "an object with the fields area, emission, reflectance, F", json.type_name());
    for (const auto& [name, value] : json.items())
        if (std::ranges::find(fields, name) == fields.end())
            throw Error({source}, "only the fields area, emission, reflectance, F", with_suggestion(name, fields));
}

std::vector<Color> colors(const Value& list, std::size_t patches, const std::string& expected,
                          bool (*is_good)(double)) {
    list.check_size(patches, "patches, as many as \"area\" has");
    std::vector<Color> read;
    for (std::size_t i = 0; i < patches; ++i) read.push_back(list.at(i).color(expected, is_good));
    return read;
}

FormFactors form_factors(const Value& rows, std::size_t patches, const MemoryLimit& limit) {
    rows.check_size(patches, "rows, as many as \"area\" has");
    check_memory(form_factors_need(patches), limit, {rows.source});
    FormFactors read(patches);
    for (std::size_t i = 0; i < patches; ++i) {
        const Value row = rows.at(i);
        row.check_size(patches, "form factors");
        for (std::size_t j = 0; j < patches; ++j)
            read.at(i, j) = row.at(j).number("a form factor of at least 0", is_not_negative);
    }
    return read;
}

}  // namespace

MemoryNeed form_factors_need(std::size_t patches) {
    const auto n = static_cast<double>(patches);
    return {.bytes = n * n * sizeof(double),
            .what = "a matrix of form factors",
            .why = fmt::format("{} x {} doubles", patches, patches)};
}

RadiositySystem system_from_json(const ordered_json& json, const std::string& source, const MemoryLimit& limit) {
    check_fields(json, source);
    const Value areas = field(json, source, "area");
    if (!areas.json.is_array()) areas.refuse("an array of areas");
    const std::size_t patches = areas.json.size();
    std::vector<double> area;
    for (std::size_t i = 0; i < patches; ++i) area.push_back(areas.at(i).number("an area above 0", is_area));
    return {.area = std::move(area),
            .emission = colors(field(json, source, "emission"), patches, "an emission of at least 0", is_not_negative),
            .reflectance =
                colors(field(json, source, "reflectance"), patches, "a reflectance from 0 to below 1", is_reflectance),
            .form_factors = form_factors(field(json, source, "F"), patches, limit)};
}

RadiositySystem read_system(const std::filesystem::path& path, const MemoryLimit& limit) {
    return system_from_json(read_json(path, limit), path.string(), limit);
}

}  // namespace raylab

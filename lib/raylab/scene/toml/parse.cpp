#include "raylab/base/error.h"
#include "raylab/scene/toml/skim.h"
#include "raylab/scene/toml/value.h"

#include <toml++/toml.h>

#include <algorithm>
#include <tuple>

namespace raylab::toml_file {

namespace {

Value convert(const toml::node& node);

int line_of(const toml::source_region& region) { return static_cast<int>(region.begin.line); }

Value::Array convert_array(const toml::array& array) {
    Value::Array result;
    for (const toml::node& element : array) result.push_back(convert(element));
    return result;
}

// toml++ sorts tables by name; the order of the file is the order of a scene's objects.
Value::Table convert_table(const toml::table& table) {
    Value::Table result;
    for (const auto& [key, node] : table)
        result.push_back({.name = std::string(key.str()),
                          .value = convert(node),
                          .line = line_of(key.source()),
                          .column = static_cast<int>(key.source().begin.column)});
    std::ranges::sort(result, {}, [](const Entry& entry) { return std::tie(entry.line, entry.column); });
    return result;
}

Value convert(const toml::node& node) {
    Value result{.data = Value::Date{}, .line = line_of(node.source())};
    if (const auto* table = node.as_table()) result.data = convert_table(*table);
    if (const auto* array = node.as_array()) result.data = convert_array(*array);
    if (const auto* text = node.as_string()) result.data = text->get();
    if (const auto* whole = node.as_integer()) result.data = whole->get();
    if (const auto* number = node.as_floating_point()) result.data = number->get();
    if (const auto* flag = node.as_boolean()) result.data = flag->get();
    return result;
}

}  // namespace

Value parse(std::string_view text, const std::string& file) {
    refuse_what_breaks_the_parser(text, file);
    try {
        return convert(toml::parse(text, file));
    } catch (const toml::parse_error& error) {
        const std::string why(error.description());
        throw Error(to_string(Place{file, line_of(error.source())}) + ": this is no TOML: " + why);
    }
}

}  // namespace raylab::toml_file

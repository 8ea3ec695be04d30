#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/scene/read_scene.h"
#include "raylab/scene/toml/scene_format.h"

#include "sanitized.h"
#include "scene/json_schema_validator.h"

#include <filesystem>
#include <functional>

using namespace raylab;
using namespace raylab::toml_file;
using nlohmann::json;

namespace {

const std::string every_key_file = RAYLAB_SOURCE "/tests/scene/files/every_key.toml";

json to_json(const Value& value) {
    if (const auto* array = std::get_if<Value::Array>(&value.data)) {
        json result = json::array();
        for (const auto& each : *array) result.push_back(to_json(each));
        return result;
    }
    if (const auto* table = std::get_if<Value::Table>(&value.data)) {
        json result = json::object();
        for (const auto& each : *table) result[each.name] = to_json(each.value);
        return result;
    }
    if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
    if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return *whole;
    if (const auto* number = std::get_if<double>(&value.data)) return *number;
    return std::get<bool>(value.data);
}

bool reader_accepts(const Value& scene) {
    try {
        check(scene, scene_format(), "mutant", "the scene");
        return true;
    } catch (const Error&) {
        return false;
    }
}

const std::vector<Value>& replacements() {
    static const std::vector<Value> values{{.data = "zzz"},
                                           {.data = ""},
                                           {.data = true},
                                           {.data = std::int64_t{-1}},
                                           {.data = std::int64_t{0}},
                                           {.data = 2.5},
                                           {.data = 1e39},
                                           {.data = 200.},
                                           {.data = Value::Array{}},
                                           {.data = Value::Table{}},
                                           {.data = Value::Array{{.data = 0.0}, {.data = 0.5}, {.data = 0.0}}}};
    return values;
}

// Calls `visit` once for each way to change one thing somewhere in the tree below `value`, and undoes each change.
void for_each_mutant(Value& value, const std::function<void()>& visit) {
    const Value original = value;
    for (const auto& replacement : replacements()) {
        value = replacement;
        visit();
    }
    value = original;
    if (auto* array = std::get_if<Value::Array>(&value.data); array && !array->empty()) {
        for (auto& each : *array) for_each_mutant(each, visit);
        array->push_back(array->back());
        visit();
        array->resize(array->size() - 2);
        visit();
        value = original;
    }
    if (auto* table = std::get_if<Value::Table>(&value.data)) {
        for (auto& each : *table) for_each_mutant(each.value, visit);
        table->push_back({.name = "unheard_of", .value = {.data = 1.0}});
        visit();
        for (std::size_t i = 0; i + 1 < table->size(); ++i) {
            value = original;
            table = &std::get<Value::Table>(value.data);
            table->erase(table->begin() + static_cast<std::ptrdiff_t>(i));
            visit();
        }
        value = original;
    }
}

}  // namespace

TEST_CASE("the schema beside the reader is the one its format gives") {
    const auto generated = scene_schema();
    if (generated != read_file(RAYLAB_SOURCE "/lib/raylab/scene/scene.schema.json")) {
        write_file(RAYLAB_BUILD "/scene.schema.json", generated);
        FAIL("lib/raylab/scene/scene.schema.json is out of date: copy " RAYLAB_BUILD "/scene.schema.json over it");
    }
}

TEST_CASE("the tables of keys in the scene format's README are the ones its format gives") {
    const auto readme = read_file(RAYLAB_SOURCE "/lib/raylab/scene/FORMAT.md");
    const std::string mark = "<!-- From here on made from the reader's own description of the format. -->\n";
    const auto end_of_prose = readme.find(mark) + mark.size();
    REQUIRE(readme.find(mark) != readme.npos);
    const auto generated = readme.substr(0, end_of_prose) + reference(scene_format());
    if (generated != readme) {
        write_file(RAYLAB_BUILD "/scene_README.md", generated);
        FAIL("lib/raylab/scene/FORMAT.md is out of date: copy " RAYLAB_BUILD "/scene_README.md over it");
    }
}

TEST_CASE("the whole scene in the scene format's README is one") {
    const auto readme = read_file(RAYLAB_SOURCE "/lib/raylab/scene/FORMAT.md");
    const std::string fence = "```toml\n";
    const auto begin = readme.find(fence) + fence.size();
    const auto scene = read_scene_text(readme.substr(begin, readme.find("```\n", begin) - begin), "README.toml");
    CHECK(scene.objects.size() == 1);
    CHECK(scene.lights.size() == 1);
}

TEST_CASE("reader and schema agree on every scene that differs from a valid one in one place") {
    const JsonSchemaValidator schema(json::parse(scene_schema()));
    Value scene = parse(read_file(every_key_file), every_key_file);
    REQUIRE(reader_accepts(scene));
    REQUIRE(schema.accepts(to_json(scene)));
    int accepted = 0;
    int refused = 0;
    for_each_mutant(scene, [&] {
        const bool by_reader = reader_accepts(scene);
        ++(by_reader ? accepted : refused);
        if (is_sanitized && (accepted + refused) % 8 != 0) return;  // a sanitizer checks the reader
        if (by_reader != schema.accepts(to_json(scene))) FAIL_CHECK("they disagree on " << to_json(scene).dump());
    });
    CHECK(accepted > 100);
    CHECK(refused > 1000);
}

TEST_CASE("every scene of the chapters obeys the schema") {
    const JsonSchemaValidator schema(json::parse(scene_schema()));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RAYLAB_SOURCE "/chapters"))
        if (entry.path().extension() == ".toml") {
            INFO(entry.path());
            CHECK(schema.accepts(to_json(parse(read_file(entry.path()), entry.path().string()))));
            CHECK_NOTHROW(read_scene(entry.path()));
        }
}

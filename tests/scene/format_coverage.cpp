#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/scene/toml/scene_format.h"

#include <set>
#include <string>

using namespace raylab;

namespace {

using namespace raylab::toml_file;

// Records every key of the format that a checked value uses, as "sphere.radius".
class Used {
public:
    std::set<std::string> keys;

    void note(const Value& value, const Format& format) {
        if (const auto* table = std::get_if<Table>(&format.kind)) note_table(value, *table);
        if (const auto* tagged = std::get_if<Tagged>(&format.kind)) note_table(value, chosen(*tagged, value));
        if (const auto* list = std::get_if<List>(&format.kind); list && !is_table(value))
            for (const auto& each : std::get<Value::Array>(value.data)) note(each, *list->element);
        if (const auto* named = std::get_if<Named>(&format.kind))
            for (const auto& entry : std::get<Value::Table>(value.data)) note(entry.value, *named->element);
        if (const auto* either = std::get_if<Either>(&format.kind); either && is_table(value))
            for (const auto& choice : either->choices) note(value, choice);
    }

private:
    static bool is_table(const Value& value) { return std::holds_alternative<Value::Table>(value.data); }

    void note_table(const Value& value, const Table& table) {
        for (const auto& entry : std::get<Value::Table>(value.data)) {
            keys.insert(table.what + "." + entry.name);
            note(entry.value, find(table, entry.name)->format);
        }
    }
};

// Every key that the format describes.
class Described {
public:
    std::set<std::string> keys;

    void note(const Format& format) {
        if (const auto* table = std::get_if<Table>(&format.kind)) note_table(*table);
        if (const auto* tagged = std::get_if<Tagged>(&format.kind))
            for (const auto& alternative : tagged->alternatives) note_table(alternative.table);
        if (const auto* list = std::get_if<List>(&format.kind)) note(*list->element);
        if (const auto* named = std::get_if<Named>(&format.kind)) note(*named->element);
        if (const auto* either = std::get_if<Either>(&format.kind))
            for (const auto& choice : either->choices) note(choice);
    }

private:
    void note_table(const Table& table) {
        for (const auto& key : table.keys) {
            keys.insert(table.what + "." + key.name);
            note(key.format);
        }
    }
};

}  // namespace

TEST_CASE("the file of every key has every key of the format but those that repeat") {
    const std::string file = RAYLAB_SOURCE "/tests/scene/files/every_key.toml";
    const auto root = parse(read_file(file), file);
    Used used;
    used.note(root, scene_format());
    Described described;
    described.note(scene_format());
    std::set<std::string> missing;
    for (const auto& key : described.keys)
        if (!used.keys.contains(key)) missing.insert(key);
    // The keys that all shapes share are read by one function, tested with the sphere and the triangle; the
    // orthographic camera has a test of its own.
    std::erase_if(missing, [](const std::string& key) {
        return key.ends_with(".material") || key.ends_with(".transform") || key.ends_with(".motion") ||
               key.ends_with(".transform_end") || key.ends_with(".sides") || key.starts_with("an orthographic camera.");
    });
    CHECK(missing.empty());
}

#include "name_list.h"

#include "raylab/report/json_text.h"

#include <nlohmann/json.hpp>

namespace raylab {

void list_names(const std::vector<ListedName>& names, const std::optional<std::string>& json, Outputs& outputs) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& [name, chapter] : names) {
        list.push_back({{"name", name}, {"chapter", chapter}});
        if (json != "-") outputs.say(name + "  (chapter " + chapter + ")\n");
    }
    if (json) write_json(json_text(list), outputs[*json]);
    outputs.commit();
}

}  // namespace raylab

#include "retired_names.h"

#include "raylab/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace raylab {

namespace {

struct Renamed {
    std::string_view old_name, new_name;
};

// Every name that a command line may not use any more. It serves the messages below and nothing else.
constexpr std::array retired_options{Renamed{"--feelers", "--shadow-rays"}};
constexpr std::array structures{
    Renamed{"sphere_tree", "bvh_sphere"}, Renamed{"aabb_tree", "bvh"}, Renamed{"aabb_splits", "bvh_splits"},
    Renamed{"obb_tree", "bvh_obb"},       Renamed{"wide", "bvh8"},     Renamed{"wide_plain", "bvh8_plain"},
};
constexpr std::array options_with_structures{"--accelerator", "--peers", "--structure"};

template <class Table>
void refuse(const Table& table, std::string_view word) {
    const auto found = std::ranges::find(table, word, &Renamed::old_name);
    if (found != table.end()) throw Error(fmt::format("{} is called {}", found->old_name, found->new_name));
}

}  // namespace

void refuse_retired_structures(const std::string& list) {
    std::istringstream names(list);
    for (std::string name; std::getline(names, name, ',');)
        refuse(structures, std::string_view(name).substr(0, name.find(':')));
}

void refuse_retired_names(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        const std::size_t equals = word.find('=');
        const std::string_view option = word.substr(0, equals);
        refuse(retired_options, option);
        if (std::ranges::find(options_with_structures, option) == options_with_structures.end()) continue;
        if (equals != std::string_view::npos)
            refuse_retired_structures(words[i].substr(equals + 1));
        else if (i + 1 < words.size())
            refuse_retired_structures(words[i + 1]);
    }
}

}  // namespace raylab

#include "raylab/base/numbered_name.h"

#include "raylab/base/nearest_name.h"
#include "raylab/base/small_letters.h"

#include <algorithm>
#include <vector>

namespace raylab {

namespace {

struct NumberedName {
    std::string_view number, name;
};

NumberedName parts(std::string_view folder) {
    const auto middle = folder.find('_');
    return {folder.substr(0, middle), middle == std::string_view::npos ? "" : folder.substr(middle + 1)};
}

// "07b" -> "7b".
std::string_view without_zeros(std::string_view number) {
    return number.substr(std::min(number.find_first_not_of('0'), number.size()));
}

}  // namespace

bool means_folder(std::string_view word, std::string_view folder) {
    const auto [number, name] = parts(folder);
    return equal_ignoring_case(word, folder) || (!name.empty() && equal_ignoring_case(word, name)) ||
           (!word.empty() && equal_ignoring_case(without_zeros(word), without_zeros(number)));
}

std::string with_suggested_folder(std::string_view word, std::span<const std::string> folders) {
    std::vector<std::string> known(folders.begin(), folders.end());
    for (const auto& folder : folders) known.emplace_back(parts(folder).name);
    return with_suggestion(word, known);
}

}  // namespace raylab

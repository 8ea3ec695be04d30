#include "raylab/base/with_all_replaced.h"

#include <cassert>

namespace raylab {

std::string with_all_replaced(std::string_view text, std::string_view part, std::string_view by) {
    assert(!part.empty());
    std::string result;
    for (auto at = text.find(part); at != text.npos; at = text.find(part)) {
        result.append(text.substr(0, at)).append(by);
        text.remove_prefix(at + part.size());
    }
    return result.append(text);
}

}  // namespace raylab

#include "raylab/base/error.h"

#include "raylab/base/printable.h"

namespace raylab {

std::string to_string(const Place& place) {
    std::string text = place.file;
    if (place.line > 0) text += ":" + std::to_string(place.line);
    if (!place.inside.empty()) text += " " + place.inside;
    return text;
}

Error::Error(const Place& place, const std::string& expected, const std::string& found)
    : std::runtime_error(printable(to_string(place) + ": expected " + expected + ", found " + found)) {}

Error::Error(const std::string& message) : std::runtime_error(printable(message)) {}

}  // namespace raylab

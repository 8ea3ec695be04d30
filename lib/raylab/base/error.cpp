#include "raylab/base/error.h"

#include <algorithm>

namespace raylab {

namespace {

// The message may quote what a file holds; a control character would break the promise of one line.
std::string one_line(std::string text) {
    std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return text;
}

}  // namespace

std::string to_string(const Place& place) {
    std::string text = place.file;
    if (place.line > 0) text += ":" + std::to_string(place.line);
    if (!place.inside.empty()) text += " " + place.inside;
    return text;
}

Error::Error(const Place& place, const std::string& expected, const std::string& found)
    : std::runtime_error(one_line(to_string(place) + ": expected " + expected + ", found " + found)) {}

Error::Error(const std::string& message) : std::runtime_error(one_line(message)) {}

}  // namespace raylab

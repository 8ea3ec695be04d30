#pragma once

#include <stdexcept>
#include <string>

namespace raylab {

/// The place of bad input: a file and, where known, a line (from 1) or a place inside such as a JSON pointer.
struct Place {
    std::string file;
    int line = 0;             // 0: the file as a whole
    std::string inside = {};  // e.g. "/tests/3" or "record 17"
};

/// "scene.toml:14", "hits.json /tests/3" or "bunny.stl".
std::string to_string(const Place& place);

/// The only way to refuse bad input (file, option, scene, mesh, case). Mistakes of the program itself are assertions
/// instead. what() is one printable line (see base/printable.h): "scene.toml:14: expected kr + kt <= 1, found 1.2".
class Error : public std::runtime_error {
public:
    Error(const Place& place, const std::string& expected, const std::string& found);
    explicit Error(const std::string& message);
};

}  // namespace raylab

#pragma once

#include "raylab/scene/needs.h"
#include "raylab/scene/read_scene.h"

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

// Small scenes for the tests of needs, and functions that read the answers.

inline raylab::Scene scene_of(const std::string& toml) {
    return raylab::read_scene_text("raylab = 1\n" + toml, "needs.toml");
}

namespace pieces {

inline const std::string red = "[material.red]\ndiffuse = [0.8, 0.1, 0.1]\n";
inline const std::string mirror = "[material.mirror]\ndiffuse = [0, 0, 0]\nkr = 0.5\n";
inline const std::string glass = "[material.glass]\ndiffuse = [0, 0, 0]\nkr = 0.25\nkt = 0.5\nior = 1.5\n";
inline const std::string light = "[[light]]\ntype = \"point\"\nposition = [3, 6, 4]\n";

inline std::string sphere(const std::string& material, const std::string& more = "") {
    return "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"" + material + "\"\n" + more;
}
inline std::string floor(const std::string& material) {
    return "[[shape]]\ntype = \"plane\"\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\nmaterial = \"" + material + "\"\n";
}

}  // namespace pieces

// How many of the expressions match the path.
inline int matches(const std::vector<raylab::LightPath>& paths, const std::string& path) {
    return static_cast<int>(std::ranges::count_if(
        paths, [&](const raylab::LightPath& p) { return std::regex_match(path, std::regex(p.expression)); }));
}

inline bool mentions(const std::vector<raylab::Note>& notes, const std::string& what) {
    return std::ranges::find(notes, what, &raylab::Note::what) != notes.end();
}

#include "raylab/report/radiosity/walk_through.h"

#include "raylab/base/base64.h"
#include "raylab/base/bytes.h"
#include "raylab/base/file.h"
#include "raylab/report/page/embedded.h"
#include "raylab/report/page/html.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <numbers>
#include <vector>

namespace raylab {

namespace {

// three.js is minified, so its notice is not in it any more.
constexpr const char* licence_of_three = R"(/*
three.js r111, as Debian's package libjs-three has it. Copyright (c) 2010-2019 three.js authors. The MIT License:

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation
files (the "Software"), to deal in the Software without restriction, including without limitation the rights to use, copy,
modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the Software
is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES
OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE
LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR
IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
*/
)";

constexpr const char* controls =
    R"(<canvas tabindex="0" aria-label="The scene: drag to look around, W A S D to walk"></canvas>
<div class="bar">
<label>exposure <input id="exposure" type="range" min="-6" max="6" step="0.1" value="0"><output></output></label>
<label><input id="patches" type="checkbox"> patches</label>
<label><input id="lines" type="checkbox"> mesh</label>
<button id="reset">back to the start</button>
<span class="keys">drag: look around · <kbd>W</kbd> <kbd>A</kbd> <kbd>S</kbd> <kbd>D</kbd> or arrows: walk · <kbd>E</kbd> <kbd>Q</kbd>: up,
down · <kbd>P</kbd>: patches · <kbd>L</kbd>: mesh · <kbd>+</kbd> <kbd>-</kbd>: exposure · <kbd>R</kbd>: start</span>
</div>
)";

class Numbers {
public:
    void add(const Vec3d& triple, double factor) {
        for (int axis = 0; axis < 3; ++axis)
            append_number(bytes_, static_cast<float>(factor * triple[axis]), std::endian::little);
    }
    void add(std::uint32_t number) { append_number(bytes_, number, std::endian::little); }
    std::string text() const { return base64(bytes_); }

private:
    std::string bytes_ = {};
};

std::string triples(const std::vector<Vec3d>& values, double factor) {
    Numbers numbers;
    for (const Vec3d& value : values) numbers.add(value, factor);
    return numbers.text();
}

// Four a patch; the fourth of a triangle is no vertex.
std::string corners(const PatchMesh& mesh) {
    Numbers numbers;
    for (const Patch& patch : mesh.patches)
        for (std::uint32_t i = 0; i < 4; ++i)
            numbers.add(i < patch.corner_count ? patch.vertices[i] : std::numeric_limits<std::uint32_t>::max());
    return numbers.text();
}

nlohmann::ordered_json triple(const Vec3d& value) { return {value.x, value.y, value.z}; }

nlohmann::ordered_json to_json(const Camera& camera) {
    const auto* perspective = std::get_if<Perspective>(&camera.projection);
    return {{"position", triple(camera.position)},
            {"target", triple(camera.target)},
            {"up", triple(camera.up)},
            {"fov_y", perspective ? perspective->fov_y : Perspective{}.fov_y}};
}

}  // namespace

std::string walk_through_page(const SolvedScene& solved, const Camera& camera, const std::string& title,
                              double exposure) {
    constexpr double to_radiance = 1 / std::numbers::pi;
    const nlohmann::ordered_json solution = {{"camera", to_json(camera)},
                                             {"exposure", exposure},
                                             {"vertices", triples(solved.mesh.vertices, 1)},
                                             {"atVertices", triples(solved.vertices, to_radiance)},
                                             {"corners", corners(solved.mesh)},
                                             {"ofPatches", triples(solved.patches, to_radiance)}};
    const std::string words = escape_html(title);
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\">\n<title>" +
           words + "</title>\n<style>\n" + walk_style() + "</style>\n</head>\n<body>\n<h1>" + words + "</h1>\n" +
           controls + "<script type=\"application/json\" id=\"solution\">" + solution.dump() + "</script>\n<script>\n" +
           licence_of_three + read_file(RAYLAB_THREE) + "\n</script>\n<script>\n" + walk_script() +
           "</script>\n</body>\n</html>\n";
}

}  // namespace raylab

#include "raylab/scene/needs/parts.h"
#include "raylab/scene/pigment.h"
#include "raylab/scene/render_model.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

// The names of the seen materials for which something holds.
std::vector<std::string> seen_with(const NeedsQuestion& question, const auto& holds) {
    const std::vector<bool> seen = seen_materials(question);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] && holds(question.scene.materials[i])) names.push_back(material_name(question.scene, i));
    return names;
}

bool turns_light(const Material& m) { return m.kr > 0 || m.kt > 0; }
bool spreads(const Material& m) { return turns_light(m) && !std::holds_alternative<Sharp>(m.polish); }
bool emits(const Material& m) { return m.emission != black; }

std::vector<std::string> area_lights(const Scene& scene) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (emits(scene.materials[object.front]) || emits(scene.materials[object.back]))
            names.push_back(name_of(scene, i));
    }
    return names;
}

}  // namespace

std::vector<Note> sample_dimensions(const NeedsQuestion& question, const Needs& needs) {
    std::vector<Note> notes{{"pixel", "2 numbers: where in the pixel"}};
    const Scene& scene = question.scene;
    if (needs.lens)
        notes.push_back({"lens", fmt::format("2 numbers: where on a lens of radius {}", scene.camera.lens->radius)});
    if (needs.time)
        notes.push_back({"time", fmt::format("1 number: when from {} to {} s, while something moves",
                                             scene.camera.shutter->open, scene.camera.shutter->close)});
    if (const auto names = area_lights(scene); !names.empty())
        notes.push_back({"light", "3 numbers at a surface: which area light, and where on it: " + list_of(names)});
    if (const auto names = seen_with(question, spreads); !names.empty())
        notes.push_back({"lobe", "2 numbers at a surface: the direction of gloss or roughness: " + list_of(names)});
    const auto splits = [&](const Material& m) {
        return (m.kr > 0) + (m.kt > 0) + (needs.model == RenderModel::path && !is_black(m.diffuse)) > 1;
    };
    if (const auto names = seen_with(question, splits); !names.empty())
        notes.push_back({"choice", "1 number at a surface: which lobe goes on: " + list_of(names)});
    if (needs.model == RenderModel::path)
        notes.push_back({"diffuse", "2 numbers at a surface: the direction of a diffuse lobe; from the fourth surface "
                                    "on 1 for Russian roulette"});
    return notes;
}

std::vector<Note> unreached_light(const NeedsQuestion& question, const Needs& needs) {
    std::vector<Note> notes;
    const Scene& scene = question.scene;
    std::vector<std::string> points;
    for (std::size_t i = 0; i < needs.lights.size(); ++i)
        if (needs.lights[i].shines) points.push_back(light_name(scene, i));
    const auto glass = seen_with(question, [](const Material& m) { return m.kt > 0; });
    const auto mirrors = seen_with(question, [](const Material& m) { return m.kr > 0; });
    if (!points.empty() && !glass.empty())
        notes.push_back({"light through glass", list_of(points) + " through " + list_of(glass) +
                                                    ": glass stops shadow rays, and no path hits a point; chapter 17"});
    if (!points.empty() && !mirrors.empty())
        notes.push_back({"light by mirrors", list_of(points) + " by " + list_of(mirrors) +
                                                 " onto a diffuse surface: no path hits a point; chapter 17"});
    const bool turned = !glass.empty() || !mirrors.empty();
    if (needs.model == RenderModel::path && turned && !area_lights(scene).empty())
        notes.push_back({"caustics of area lights", "found where a path hits one by chance: with noise; chapter 17"});
    if (needs.model == RenderModel::distributed)
        notes.push_back({"diffuse to diffuse", "the ambient term stands in for it; --model path computes it"});
    return notes;
}

}  // namespace raylab

#include "raylab/scene/background.h"
#include "raylab/scene/needs/spread.h"

#include <fmt/format.h>

namespace raylab {

namespace {

// All lobes of a model that follows all of them.
std::vector<LightPath> paths_of_all_light(const Scene& scene, const SpreadFacts& facts) {
    const bool diffuse = !facts.diffuse.empty(), specular = !(facts.mirrors.empty() && facts.glass.empty());
    const bool surroundings = sends_light(scene.background);
    const bool any_light = !(facts.points.empty() && facts.area_lights.empty()) || surroundings;
    std::vector<LightPath> paths;
    if (!facts.emission.empty()) paths.push_back({"LE", "a surface that sends out light is seen itself"});
    if (any_light && (diffuse || specular))
        paths.push_back({diffuse && specular ? "L(D|S)+E"
                         : diffuse           ? "LD+E"
                                             : "LS+E",
                         std::string("over any number of surfaces") +
                             (surroundings ? "; the background is a light all around" : "")});
    return paths;
}

std::vector<LightPath> paths_of_distributed_rays(const SpreadFacts& facts) {
    const bool highlight = !facts.spreading.empty() || !(facts.highlights.empty() || facts.points.empty());
    const std::string local = facts.diffuse.empty() ? "S" : highlight ? "(D|S)" : "D";
    const bool turns = !(facts.mirrors.empty() && facts.glass.empty());
    const std::string by = facts.glass.empty()     ? "in mirrors"
                           : facts.mirrors.empty() ? "through glass"
                                                   : "in mirrors and through glass";
    std::vector<LightPath> paths;
    if (facts.is_lit()) paths.push_back({"L" + local + "E", "local: light falls on a surface, which spreads it"});
    if (!facts.emission.empty()) paths.push_back({"LE", "a surface that sends out light is seen itself"});
    if (facts.is_lit() && turns) paths.push_back({"L" + local + "S+E", "the same, seen " + by});
    if (!facts.emission.empty() && turns) paths.push_back({"LS+E", "a surface that sends out light, seen " + by});
    return paths;
}

}  // namespace

std::vector<LightPath> spread_paths(const Scene& scene, const SpreadFacts& facts) {
    return facts.model == RenderModel::path ? paths_of_all_light(scene, facts) : paths_of_distributed_rays(facts);
}

std::vector<Note> asked_of_spread(const Scene& scene, const Needs& needs, const SpreadFacts& facts) {
    const bool is_path = facts.model == RenderModel::path;
    std::vector<Note> notes;
    const auto add = [&](const std::string& what, const std::vector<std::string>& names) {
        if (!names.empty()) notes.push_back({what, list_of(names)});
    };
    if (!is_path) add("ambient term", facts.ambient);
    if (is_path || facts.is_lit()) add("diffuse lobe", facts.diffuse);
    if (!is_path && !facts.points.empty()) add("highlights", facts.highlights);
    add("checkers", facts.checkers);
    add("gloss and roughness", facts.spreading);
    add("emission", facts.emission);
    if (facts.is_lit()) {
        add("shadow rays to points", facts.points);
        add("shadow rays to surfaces", facts.area_lights);
    }
    add("reflected rays", facts.mirrors);
    add("transmitted rays", facts.glass);
    if (is_path || !(facts.mirrors.empty() && facts.glass.empty()))
        notes.push_back({"any depth", "chance ends a path that carries little (Russian roulette), or --depth"});
    if (needs.lens) notes.push_back({"lens samples", fmt::format("a lens of radius {}", scene.camera.lens->radius)});
    if (needs.time) notes.push_back({"time samples", "something moves while the shutter is open"});
    notes.push_back({"accelerator", needs.accelerator + ": " + primitives_of(needs)});
    return notes;
}

std::vector<Note> left_out_of_spread(const Scene& scene, const Needs& needs, const SpreadFacts& facts) {
    std::vector<Note> notes;
    const auto add = [&](const std::string& what, bool is_left_out, const std::string& why) {
        if (is_left_out) notes.push_back({what, why});
    };
    const bool no_light = facts.points.empty() && facts.area_lights.empty();
    add("shadow rays", !facts.is_lit(), no_light ? "there is no light" : "nothing that is seen spreads light");
    add("reflected rays", facts.mirrors.empty(), "nothing that is seen has a kr");
    add("transmitted rays", facts.glass.empty(), "nothing that is seen has a kt");
    add("gloss and roughness", facts.spreading.empty(), "what mirrors or lets light pass is sharp");
    add("emission", facts.emission.empty(), "nothing that is seen sends out light");
    add("lens samples", !needs.lens, "the camera is a pinhole: everything is in focus");
    add("time samples", !needs.time, why_no_time(scene));
    add("a tree", needs.accelerator.ends_with("list"), primitives_of(needs) + ": a list is faster");
    return notes;
}

}  // namespace raylab

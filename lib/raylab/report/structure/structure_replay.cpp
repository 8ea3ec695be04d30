#include "raylab/report/structure/structure_replay.h"

#include "raylab/accelerator/check_ray.h"
#include "raylab/base/read_json.h"
#include "raylab/report/json_text.h"
#include "raylab/report/structure/structure_replay_json.h"

namespace raylab {

using nlohmann::ordered_json;

namespace {

ordered_json json_of(const Ray& ray) {
    ordered_json json{{"origin", replay::json_of(ray.origin)},
                      {"direction", replay::json_of(ray.direction)},
                      {"range", {replay::json_of(ray.range.min), replay::json_of(ray.range.max)}}};
    if (ray.leaving != no_primitive) json["leaving"] = {ray.leaving.object, ray.leaving.part};
    return json;
}

Ray ray_of(const replay::Value& json) {
    Ray ray{.origin = json.at("origin").vector(), .direction = json.at("direction").vector()};
    ray.range = {json.at("range").at(0).number_or_infinity(), json.at("range").at(1).number_or_infinity()};
    if (json.has("leaving")) ray.leaving = {json.at("leaving").at(0).whole(), json.at("leaving").at(1).whole()};
    check_ray(ray, [&] { return json.place(); });
    return ray;
}

}  // namespace

std::string to_json(const StructureDifference& difference) {
    ordered_json json{{"raylab", "difference"},
                      {"structure", difference.structure},
                      {"scene", difference.scene_kind},
                      {"rays_aimed", difference.ray_kind},
                      {"seed", difference.seed},
                      {"piece", difference.piece},
                      {"expected", difference.answers.expected},
                      {"found", difference.answers.found},
                      {"objects", ordered_json::array()},
                      {"rays", ordered_json::array()}};
    for (const Object& object : difference.smallest.scene.objects) json["objects"].push_back(replay::json_of(object));
    for (const Ray& ray : difference.smallest.rays) json["rays"].push_back(json_of(ray));
    return json_text(json);
}

StructureDifference read_difference(const std::filesystem::path& path) {
    const auto json = read_json(path);
    const replay::Value file(json, path.string(), "");
    if (file.at("raylab").text() != "difference") file.refuse("a difference that raylab stability wrote");
    StructureDifference difference{.structure = file.at("structure").text(),
                                   .scene_kind = file.at("scene").text(),
                                   .ray_kind = file.at("rays_aimed").text(),
                                   .smallest = {},
                                   .answers = {file.at("expected").text(), file.at("found").text()}};
    for (std::size_t i = 0; i < file.at("objects").size(); ++i)
        difference.smallest.scene.objects.push_back(replay::object_of(file.at("objects").at(i)));
    for (std::size_t i = 0; i < file.at("rays").size(); ++i)
        difference.smallest.rays.push_back(ray_of(file.at("rays").at(i)));
    if (difference.smallest.rays.empty()) file.at("rays").refuse("at least one ray");
    return difference;
}

}  // namespace raylab

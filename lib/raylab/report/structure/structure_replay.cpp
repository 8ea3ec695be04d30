#include "raylab/report/structure/structure_replay.h"

#include "raylab/accelerator/check_ray.h"
#include "raylab/base/read_json.h"
#include "raylab/report/json_text.h"
#include "raylab/report/structure/structure_replay_json.h"
#include "raylab/scene/check_shape.h"
#include "raylab/scene/moving.h"

namespace raylab {

using nlohmann::ordered_json;

namespace {

ordered_json json_of(const Ray& ray) {
    ordered_json json{{"origin", replay::json_of(ray.origin)},
                      {"direction", replay::json_of(ray.direction)},
                      {"range", {replay::json_of(ray.range.min), replay::json_of(ray.range.max)}}};
    if (ray.leaving != no_primitive) json["leaving"] = {ray.leaving.object, ray.leaving.part};
    if (ray.time != 0) json["time"] = replay::json_of(ray.time);
    return json;
}

Ray ray_of(const replay::Value& json) {
    Ray ray{.origin = json.at("origin").vector(), .direction = json.at("direction").vector()};
    ray.range = {json.at("range").at(0).number_or_infinity(), json.at("range").at(1).number_or_infinity()};
    if (json.has("leaving")) ray.leaving = {json.at("leaving").at(0).whole(), json.at("leaving").at(1).whole()};
    if (json.has("time")) ray.time = json.at("time").number();
    check_ray(ray, [&] { return json.place(); });
    return ray;
}

Shutter shutter_of(const replay::Value& json) {
    const Shutter shutter{json.at(0).exact_number(), json.at(1).exact_number()};
    if (!(shutter.open <= shutter.close)) json.refuse("a shutter that opens before it closes");
    return shutter;
}

void check_moments(const StructureCase& of, const replay::Value& file) {
    const Interval<float> times = ray_times(of.scene);
    for (std::size_t i = 0; i < of.rays.size(); ++i)
        if (!contains(times, of.rays[i].time)) file.at("rays").at(i).refuse("a time while the shutter is open, or 0");
    for (std::size_t i = 0; i < of.scene.objects.size(); ++i) {
        const Object& object = of.scene.objects[i];
        if (object.motion) check_motion(object.placement, *object.motion, times, file.at("objects").at(i).place());
    }
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
    const Scene& scene = difference.smallest.scene;
    if (scene.camera.shutter) json["shutter"] = {scene.camera.shutter->open, scene.camera.shutter->close};
    for (const Object& object : scene.objects) json["objects"].push_back(replay::json_of(object));
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
    if (file.has("shutter")) difference.smallest.scene.camera.shutter = shutter_of(file.at("shutter"));
    for (std::size_t i = 0; i < file.at("objects").size(); ++i)
        difference.smallest.scene.objects.push_back(replay::object_of(file.at("objects").at(i)));
    for (std::size_t i = 0; i < file.at("rays").size(); ++i)
        difference.smallest.rays.push_back(ray_of(file.at("rays").at(i)));
    check_moments(difference.smallest, file);
    if (difference.smallest.rays.empty()) file.at("rays").refuse("at least one ray");
    return difference;
}

}  // namespace raylab

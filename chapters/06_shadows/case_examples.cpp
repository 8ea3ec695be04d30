#include "case_examples.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/number_text.h"
#include "raylab/report/case_drawings.h"
#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

namespace raylab::shadows {

namespace {

using namespace plane_ink;

std::optional<Vec3d> first_hit(const Scene& scene, const Ray& ray) {
    Traversal traversal;
    const auto hit = make_accelerator("list", scene)->closest(ray, traversal);
    if (!hit) return std::nullopt;
    return convert<double>(ray.origin) + hit->t * convert<double>(ray.direction);
}

Vec3d begin_of(const Ray& ray) {
    return convert<double>(ray.origin) + double{ray.range.min} * convert<double>(ray.direction);
}

}  // namespace

CaseExample example_of(const Scene& scene, const NamedStart& start, const ShadowQuestion& question, Shade truth) {
    const SurfacePoint at = surface_point(scene, question.arrived, question.hit);
    const Vec3d normal = facing(at.normal, convert<double>(question.arrived.direction));
    const Vec3d to_light = glm::normalize(question.light - at.position);
    const CasePlane plane{at.position, glm::normalize(to_light - dot(to_light, normal) * normal), normal};
    const Ray ray = shadow_ray_from(scene, start.start, question), right = shadow_ray_from(scene, {}, question);
    const auto met = first_hit(scene, truth == Shade::lit ? ray : right);
    const PlanePoint begin = plane.at(begin_of(ray)), other = met ? plane.at(*met) : begin;
    const auto all = case_drawing_around({{0, 0}, begin, other});
    const double size = std::max(all.high.x - all.low.x, all.high.y - all.low.y);
    PlaneSketch sketch;
    sketch.line({all.low.x - size, 0}, {all.high.x + size, 0}, stroke(blue, 3));
    sketch.arrow(begin, {begin.x + size * dot(to_light, plane.right), begin.y + size * dot(to_light, plane.up)},
                 stroke(vermilion, 2));
    sketch.dot({0, 0}, 3, blue);
    sketch.dot(begin, 5);
    if (met) sketch.dot(other, 5, truth == Shade::lit ? vermilion : green);
    auto drawing = case_drawing_around({{0, 0}, begin, other, {0.3 * size, 0.3 * size}, {-0.3 * size, -0.2 * size}});
    drawing.marks = sketch.marks();
    drawing.notes = {
        fmt::format("Its start (black) is {} m off.", number_text(glm::length(begin_of(ray) - at.position))),
        truth == Shade::lit ? "It hits (orange) what it leaves." : "It begins beyond what blocks it (green)."};
    return {in_words(question.arrived) +
                fmt::format(", light at [{}, {}, {}]", question.light.x, question.light.y, question.light.z),
            drawing};
}

}  // namespace raylab::shadows

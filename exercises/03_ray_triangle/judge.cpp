#include "03_ray_triangle/slot.h"
#include "arguments.h"
#include "boundary.h"
#include "cases.h"
#include "exercise_list.h"
#include "known.h"
#include "symptoms.h"
#include "words.h"

#include "raylab/geometry/oracle/oracle.h"

#include <algorithm>
#include <array>
#include <limits>

namespace raylab::grading {

namespace {

using namespace ray_triangle;

constexpr double safe_margin = 1e-6;   // of every determinant, relative: far more than methods in double lose
constexpr double close_margin = 1e-7;  // of rays that pass an edge as closely as any graded one: still a hundred
                                       // million times a double's rounding
constexpr double tolerance = 1e-8;     // of t (relative), u and v

bool safe(const Case& question, double margin) {
    if (question.kind == Case::Kind::adversarial || question.group == "in the triangle's plane") return true;
    const auto [ray, triangle] = arguments(question.input);
    return oracle::margin(ray, triangle) >= margin;
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const auto& next, double margin = safe_margin) {
        for (std::size_t added = 0; added < count;) {
            auto question = next(dice);
            if (!safe(question, margin)) continue;
            all.push_back(std::move(question));
            ++added;
        }
    };
    add(60, [](Dice& d) { return inside(d, "inside", 1); });
    add(90, beside);
    add(40, behind);
    add(40, [](Dice& d) { return cut(d, "range ends", 1); });
    add(30, [](Dice& d) { return cut(d, "range ends, direction of any length", d.in(0.1, 20)); });
    add(40, [](Dice& d) { return inside(d, "direction of any length", d.in(0.1, 20)); });
    add(30, small);
    add(20, coplanar);
    add(20, begins_before_start);
    add(30, just_beside, close_margin);
    add(20, beside_small);
    const auto as_they_are = [&](std::size_t count, const std::string& group, const auto& next) {
        for (std::size_t i = 0; i < count; ++i) all.push_back({group, Case::Kind::graded, as_input(next(dice))});
    };
    as_they_are(40, "edges and vertices, in whole numbers", on_edge);
    as_they_are(40, "on an edge's line beyond a vertex, in whole numbers", beyond_a_vertex);
    as_they_are(20, "a range that ends at the hit, in whole numbers", ends_at_hit);
    add(50, at_edge);
    add(50, at_vertex);
    add(50, sliver);
    return all;
}

std::string hit_words(bool hit, double t, double u, double v) {
    return hit ? fmt::format("a hit at t = {}, u = {}, v = {}", t, u, v) : "no hit";
}

// The exact hit: the truth is the point, from which u and v are computed by areas along the normal.
TriangleHit truth_at(const RayOf<double>& ray, const TriangleOf<double>& triangle, double t) {
    const Vec3d point = ray.origin + t * ray.direction - triangle.a;
    const Vec3d b = triangle.b - triangle.a;
    const Vec3d c = triangle.c - triangle.a;
    const double bb = dot(b, b), bc = dot(b, c), cc = dot(c, c), pb = dot(point, b), pc = dot(point, c);
    const double gram = bb * cc - bc * bc;
    return {t, (cc * pb - bc * pc) / gram, (bb * pc - bc * pb) / gram};
}

bool all_finite(std::span<const double> answer) {
    return std::ranges::all_of(answer, [](double value) { return std::isfinite(value); });
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto [ray, triangle] = arguments(question.input);
    const auto exact = oracle::intersect(ray, triangle);
    const auto truth = exact.hit() ? truth_at(ray, triangle, exact.t->nearest()) : TriangleHit{0, 0, 0};
    Judgement result{.expected = hit_words(exact.hit(), truth.t, truth.u, truth.v)};
    const bool hit = answer[0] != 0;
    result.got = std::isnan(answer[0]) ? "no answer" : hit_words(hit, answer[1], answer[2], answer[3]);
    if (!all_finite(answer)) {
        result.outcome = Judgement::Outcome::nonfinite;
        return result;
    }
    const bool close =
        !exact.hit() || (std::abs(answer[1] - truth.t) <= tolerance * std::abs(truth.t) &&
                         std::abs(answer[2] - truth.u) <= tolerance && std::abs(answer[3] - truth.v) <= tolerance);
    if (hit == exact.hit() && close) result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto [ray, triangle] = arguments(question.input);
    const Vec3d normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double slope = dot(ray.direction, normal);
    const double t = dot(triangle.a - ray.origin, normal) / slope;
    std::string where = "The ray runs parallel to the triangle's plane.";
    if (slope != 0) {
        const auto hit = truth_at(ray, triangle, t);
        where = fmt::format("Its line intersects the plane at t = {:.6g}, at u = {:.6g}, v = {:.6g}, u + v = "
                            "{:.6g}; inside means u >= 0, v >= 0, u + v <= 1, and t in [{}, {}] counts.",
                            hit.t, hit.u, hit.v, hit.u + hit.v, ray.range.min, ray.range.max);
    }
    return fmt::format("triangle   {} {} {}\nray        from {} along {}, t in [{}, {}]\n{}", words(triangle.a),
                       words(triangle.b), words(triangle.c), words(ray.origin), words(ray.direction), ray.range.min,
                       ray.range.max, where);
}

// An octahedron with its barycentric colours: eight triangles for each pixel, of which the nearest wins.
constexpr int picture_width = 160;
constexpr int picture_height = 120;

std::array<TriangleOf<double>, 8> octahedron() {
    const Vec3d x = glm::normalize(Vec3d{2, 0.6, 1}) * 1.2;
    const Vec3d y = glm::normalize(cross(Vec3d{0.3, 0.2, 1}, x)) * 1.2;
    const Vec3d z = cross(x, y) / 1.2;
    std::array<TriangleOf<double>, 8> faces;
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = {(i & 1 ? -x : x), (i & 2 ? -y : y), (i & 4 ? -z : z)};
    return faces;
}

RayOf<double> pixel_ray(int x, int y) {
    const double scale = 2.8 / picture_height;  // metres for each pixel
    return {{(x + 0.5 - 0.5 * picture_width) * scale, (0.5 * picture_height - y - 0.5) * scale, 5},
            {0, 0, -1},
            {0, infinity}};
}

std::vector<Case> pixel_cases(int x, int y) {
    static const auto faces = octahedron();
    std::vector<Case> cases;
    for (const auto& face : faces) cases.push_back(make("", Case::Kind::graded, pixel_ray(x, y), face));
    return cases;
}

Pixel shade(int, int, std::span<const double> answers) {
    Pixel pixel{0.02f, 0.03f, 0.06f};
    double nearest = infinity;
    for (std::size_t i = 0; i + outputs <= answers.size(); i += outputs) {
        if (answers[i] == 0 || !(answers[i + 1] < nearest)) continue;
        nearest = answers[i + 1];
        pixel = {cast<float>(1 - answers[i + 2] - answers[i + 3]), cast<float>(answers[i + 2]),
                 cast<float>(answers[i + 3])};
    }
    return pixel;
}

}  // namespace

Exercise ray_triangle_exercise() {
    return exercise_on(triangle_hit_slot, answer,
                       {.chart = "ray_triangle",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::vector, "the origin", 3},
                                      {Part::Kind::direction, "the direction", 3},
                                      {Part::Kind::number, "range.min"},
                                      {Part::Kind::number, "range.max"},
                                      {Part::Kind::vector, "the vertex a", 3},
                                      {Part::Kind::vector, "the vertex b", 3},
                                      {Part::Kind::vector, "the vertex c", 3}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::flag, "a hit"},
                                  {Part::Kind::number, "t"},
                                  {Part::Kind::number, "u"},
                                  {Part::Kind::number, "v"}},
                        .symptoms = symptoms(),
                        .story = story,
                        .picture = {.about = "an octahedron, coloured by the weights of its vertices",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading

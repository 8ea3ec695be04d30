#include "drawings.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/transform/placed_sphere.h"
#include "raylab/geometry/nearest_sphere_hit.h"
#include "raylab/image/draw.h"
#include "raylab/sampling/sequence.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/shading/surface_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace raylab::transforms {

namespace {

// A drawing in metres, with y upward and the given point in its middle.
class Plan {
public:
    Plan(const Vec3d& middle, double reach)
        : image_(width, height, {1, 1, 1}), middle_(middle), scale_(width / (2 * reach)) {}

    void line(const Vec3d& a, const Vec3d& b, double thickness, const Pixel& color) {
        draw_line(image_, at(a), at(b), thickness, color);
    }
    void arrow(const Vec3d& a, const Vec3d& b, double thickness, const Pixel& color) {
        draw_arrow(image_, at(a), at(b), thickness, color);
    }
    void dot(const Vec3d& p, const Pixel& color) { draw_disk(image_, at(p), 4.5, color); }
    void text(const Vec3d& p, const std::string& words) { draw_text(image_, at(p), 10, words, ink::black); }
    const Image& image() const { return image_; }

private:
    static constexpr int width = 440, height = 280;

    Point2 at(const Vec3d& p) const {
        return {width / 2.0 + scale_ * (p.x - middle_.x), height / 2.0 - scale_ * (p.y - middle_.y)};
    }

    Image image_;
    Vec3d middle_;
    double scale_;
};

// Draws the unit circle under a map, with its axes.
void draw_circle_under(Plan& plan, const AffineSteps& map) {
    const auto carried = [&](const Vec3d& p) { return map.columns[0] * p.x + map.columns[1] * p.y + map.translation; };
    constexpr int pieces = 96;
    for (int i = 0; i < pieces; ++i) {
        const auto on_circle = [](int k) {
            const double angle = 2 * std::numbers::pi * k / pieces;
            return Vec3d{std::cos(angle), std::sin(angle), 0};
        };
        plan.line(carried(on_circle(i)), carried(on_circle(i + 1)), 2.5, ink::blue);
    }
    plan.arrow(carried({0, 0, 0}), carried({1, 0, 0}), 1.5, ink::grey);
    plan.arrow(carried({0, 0, 0}), carried({0, 1, 0}), 1.5, ink::grey);
}

void draw_ray(Plan& plan, const RayOf<double>& ray, double hit) {
    plan.arrow(ray.origin, ray.origin + 1.3 * hit * ray.direction, 1.5, ink::vermilion);
    for (int t = 0; t <= 2; ++t) {
        const Vec3d point = ray.origin + static_cast<double>(t) * ray.direction;
        plan.dot(point, ink::vermilion);
        plan.text(point + Vec3d{0.08, 0.14, 0}, fmt::format("t = {}", t));
    }
    plan.dot(ray.origin + hit * ray.direction, ink::black);
}

Vec3d normal_of(const Scene& scene, const Ray& ray, const Hit& hit, NormalsCarried carried) {
    const auto point = surface_point(scene, ray, hit);
    if (carried == NormalsCarried::by_inverse_transpose) return point.normal;
    // The normal is transformed to object space by the transpose, and back to the world by the map itself, which is the
    // result of treating it like a point.
    const auto& c = AffineSteps::of(point.object->placement).columns;
    const Vec3d before =
        glm::normalize(Vec3d{dot(c[0], point.normal), dot(c[1], point.normal), dot(c[2], point.normal)});
    return glm::normalize(c[0] * before.x + c[1] * before.y + c[2] * before.z);
}

}  // namespace

Image draw_two_spaces() {
    AffineSteps map;
    map.columns = {Vec3d{1.1, 0, 0}, Vec3d{0.75, 0.7, 0}, Vec3d{0, 0, 1}};
    map.translation = {0.55, 0.25, 0};
    const RayOf<double> world{{-2.2, 1.2, 0}, {1.15, -0.42, 0}, {0, 10}};
    const PlacementOf<double> placement(map.rounded());
    const auto back = [&](const Vec3d& v) { return times<double>(placement.adjugate, v) / placement.determinant; };
    const RayOf<double> object{back(world.origin - map.translation), back(world.direction), world.range};
    const double hit = nearest_sphere_hit(object, {{0, 0, 0}, 1}).value();

    Plan left({0.05, 0.45, 0}, 2.7), right({-0.9, 0.25, 0}, 2.9);
    draw_circle_under(left, map);
    draw_ray(left, world, hit);
    draw_circle_under(right, {});
    draw_ray(right, object, hit);
    return side_by_side({with_caption(left.image(), "the world", 11), with_caption(right.image(), "object space", 11)},
                        20);
}

Image draw_normals(const Scene& scene, NormalsCarried carried, int threads) {
    const auto accelerator = make_accelerator("auto", scene);
    const auto frame = camera_frame(scene.camera, scene.image, scene.source);
    const Vec3d light = glm::normalize(-1.2 * frame.right + 1.6 * frame.up - 0.7 * frame.forward);
    return eye_picture(frame, {.samples = {SamplePattern::jittered, 3, 1}, .threads = threads}, [&](const Ray& ray) {
        Traversal traversal;
        const auto hit = accelerator->closest(ray, traversal);
        if (!hit) return scene.background.color;
        const auto direction = convert<double>(ray.direction);
        const Vec3d normal = facing(normal_of(scene, ray, *hit, carried), direction);
        const double lit = 0.25 + 0.75 * std::max(0.0, dot(normal, light));
        return diffuse_color(scene, surface_point(scene, ray, *hit), direction) * lit;
    });
}

Scene herd(const Scene& scene, const std::shared_ptr<const Mesh>& mesh, int rows) {
    Scene result = scene;
    std::erase_if(result.objects, [](const Object& object) { return !std::holds_alternative<Plane>(object.shape); });
    const Vec3f first = mesh->vertices.at(0);
    Vec3f low = first, high = first;
    for (const auto& vertex : mesh->vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    const Vec3d middle = (convert<double>(low) + convert<double>(high)) * 0.5;
    const double size = glm::length(convert<double>(high - low));
    const auto hide =
        static_cast<std::size_t>(std::ranges::find(scene.materials, "hide", &Material::name) - scene.materials.begin());
    assert(hide < scene.materials.size());  // the chapter's scene contains it
    RandomSequence random(4, 0);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < rows; ++column) {
            const double height = random.between(0.7, 1.2);
            const auto stand =
                AffineSteps::translate({-middle.x, -double(low.y), -middle.z})
                    .then(AffineSteps::scale(Vec3d{1, height, 1} * (2.3 / size)))
                    .then(AffineSteps::rotate({0, 1, 0}, random.between(-60, 60)))
                    .then(AffineSteps::translate({1.55 * (column - 0.5 * (rows - 1)), 0, 2.2 - 1.9 * row}));
            result.objects.push_back({.shape = mesh,
                                      .placement = stand.rounded(),
                                      .front = hide,
                                      .back = hide,
                                      .path = fmt::format("herd[{}]/mesh 0", row * rows + column)});
        }
    return result;
}

}  // namespace raylab::transforms

#include "mach_bands.h"

#include "shaded_mesh.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/tiles.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/mesh/vertex_normals.h"
#include "raylab/image/draw.h"
#include "raylab/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::lighting {

namespace {

constexpr int size = 420, chart_height = 210;
constexpr double reach = 1.08;   // metres from the middle of the picture to its edge
constexpr double line_y = 0.17;  // metres above the middle
constexpr const char* shown[] = {"flat, double", "Gouraud, double", "Phong, double"};

// A sphere of 320 triangles, intersected by parallel rays.
class CoarseSphere {
public:
    CoarseSphere() {
        scene_.materials = {{.name = "plain"}};
        scene_.objects = {{.shape = mesh_}};
        accelerator_ = make_accelerator("auto", scene_);
        shaded_.lighting.ambient = 0.08;
        shaded_.mesh = *mesh_;
    }

    const Lighting& lighting() const { return shaded_.lighting; }

    std::optional<MeshPoint> at(double x, double y) const {
        Traversal traversal;
        const Vec3d origin{x, y, 5};
        const auto hit = accelerator_->closest({.origin = convert<float>(origin), .direction = {0, 0, -1}}, traversal);
        if (!hit) return std::nullopt;
        return MeshPoint{hit->primitive.part, hit->u, hit->v};
    }

    std::vector<double> shade(const ShadingMethod& method, const std::vector<MeshPoint>& points) const {
        std::vector<double> answers(points.size());
        method.answer({}, std::span(&shaded_, 1), points, answers);
        return answers;
    }

private:
    std::shared_ptr<const Mesh> mesh_ = std::make_shared<const Mesh>(with_vertex_normals(icosphere(2)));
    Scene scene_;
    std::unique_ptr<Accelerator> accelerator_;
    ShadedMesh shaded_{.mesh = {},
                       .lighting = {.to_light = glm::normalize(Vec3d{-1, 0.6, 1.6}),
                                    .to_viewer = {0, 0, 1},
                                    .diffuse = 0.6,
                                    .specular = 0.3,
                                    .shininess = 8}};
};

double metres(double pixel) { return (pixel / size * 2 - 1) * reach; }

Pixel grey(double value) {
    const auto v = cast<float>(value);
    return {v, v, v};
}

Image draw_sphere(const CoarseSphere& sphere, const ShadingMethod& method) {
    Image image(size, size, {1, 1, 1});
    for (int y = 0; y < size; ++y) {
        std::vector<MeshPoint> points;
        std::vector<int> columns;
        for (int x = 0; x < size; ++x)
            if (const auto point = sphere.at(metres(x + 0.5), -metres(y + 0.5))) {
                points.push_back(*point);
                columns.push_back(x);
            }
        const auto row = sphere.shade(method, points);
        for (std::size_t i = 0; i < row.size(); ++i) image.at(columns[i], y) = grey(row[i]);
    }
    const double line = (1 - line_y / reach) * size / 2;
    draw_line(image, {0, line}, {10, line}, 2, ink::vermilion);
    draw_line(image, {size - 10.0, line}, {double(size), line}, 2, ink::vermilion);
    return image;
}

// Brightness along the line, in steps of a fraction of a pixel.
struct Profile {
    std::vector<double> x, value;
};

constexpr int steps = 1200;
double pixel_of(int step) { return (step + 0.5) / steps * size; }

Profile profile(const CoarseSphere& sphere, const ShadingMethod& method) {
    Profile result;
    std::vector<MeshPoint> points;
    for (int i = 0; i < steps; ++i)
        if (const auto point = sphere.at(metres(pixel_of(i)), line_y)) {
            result.x.push_back(pixel_of(i));
            points.push_back(*point);
        }
    result.value = sphere.shade(method, points);
    return result;
}

Profile exact_profile(const Lighting& lighting) {
    Profile result;
    for (int i = 0; i < steps; ++i) {
        const double pixel = pixel_of(i), x = metres(pixel), squared = 1 - x * x - line_y * line_y;
        if (squared < 0) continue;
        result.x.push_back(pixel);
        result.value.push_back(true_brightness(lighting, {x, line_y, std::sqrt(squared)}));
    }
    return result;
}

void draw_profile(Image& image, const Profile& profile, double width, const Pixel& color) {
    const auto at = [&](std::size_t i) { return Point2{profile.x[i], chart_height * (1 - profile.value[i])}; };
    for (std::size_t i = 1; i < profile.x.size(); ++i) draw_line(image, at(i - 1), at(i), width, color);
}

Image below(const Image& top, const Image& bottom) {
    Image image(top.width(), top.height() + bottom.height(), {1, 1, 1});
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < top.width(); ++x)
            image.at(x, y) = y < top.height() ? top.at(x, y) : bottom.at(x, y - top.height());
    return image;
}

}  // namespace

Image draw_mach_bands(const ChapterRun&) {
    const CoarseSphere sphere;
    std::vector<Image> images;
    for (const char* title : shown) {
        const auto method = find_method(shading_methods(), title);
        Image chart(size, chart_height, {1, 1, 1});
        draw_line(chart, {0, chart_height - 1.0}, {double(size), chart_height - 1.0}, 1, ink::grey);
        draw_profile(chart, exact_profile(sphere.lighting()), 3, ink::sky_blue);
        draw_profile(chart, profile(sphere, method), 1.5, ink::black);
        images.push_back(with_caption(below(draw_sphere(sphere, method), chart), method.name, 17));
    }
    return side_by_side(images, 16);
}

std::vector<Roughness> roughness_along_line() {
    const CoarseSphere sphere;
    std::vector<Roughness> result;
    for (const char* title : shown) {
        const auto values = profile(sphere, find_method(shading_methods(), title)).value;
        Roughness roughness{.method = title, .jump = 0, .kink = 0};
        // The rim is left out, because the exact brightness has an infinite slope there, too.
        for (std::size_t i = values.size() / 10 + 1; i + 1 < values.size() * 9 / 10; ++i) {
            const double before = values[i] - values[i - 1], after = values[i + 1] - values[i];
            roughness.jump = std::max(roughness.jump, std::abs(after));
            roughness.kink = std::max(roughness.kink, std::abs(after - before));
        }
        result.push_back(roughness);
    }
    return result;
}

}  // namespace raylab::lighting

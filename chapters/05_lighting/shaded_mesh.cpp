#include "shaded_mesh.h"

#include "highlights.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/barycentric.h"
#include "raylab/geometry/mesh/vertex_normals.h"
#include "raylab/sampling/sequence.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/gouraud_and_phong.h"
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace raylab::lighting {

namespace {

Vec3d face_normal(const Mesh& mesh, std::size_t face) {
    const auto [a, b, c] = in<double>(mesh.triangle(face));
    return glm::normalize(cross(b - a, c - a));
}

Vec3d vertex_normal(const Mesh& mesh, std::uint32_t vertex) { return convert<double>(mesh.normals[vertex]); }

void flat(const ShadedMesh& shaded, std::span<const MeshPoint> points, std::span<double> answers) {
    std::vector<double> faces(shaded.mesh.faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = brightness(shaded.lighting, face_normal(shaded.mesh, i));
    for (std::size_t i = 0; i < points.size(); ++i) answers[i] = faces[points[i].face];
}

void gouraud(const ShadedMesh& shaded, std::span<const MeshPoint> points, std::span<double> answers) {
    std::vector<double> vertices(shaded.mesh.vertices.size());
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
        vertices[i] = brightness(shaded.lighting, vertex_normal(shaded.mesh, i));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [a, b, c] = shaded.mesh.faces[points[i].face];
        answers[i] = interpolate(vertices[a], vertices[b], vertices[c], points[i].u, points[i].v);
    }
}

Vec3d mixed_normal(const Mesh& mesh, const MeshPoint& point) {
    const auto [a, b, c] = mesh.faces[point.face];
    return interpolate(vertex_normal(mesh, a), vertex_normal(mesh, b), vertex_normal(mesh, c), point.u, point.v);
}

void phong(const ShadedMesh& shaded, std::span<const MeshPoint> points, std::span<double> answers) {
    for (std::size_t i = 0; i < points.size(); ++i)
        answers[i] = brightness(shaded.lighting, glm::normalize(mixed_normal(shaded.mesh, points[i])));
}

// The formulas (4) and (5) without normalisation; they are valid for unit normals only.
void phong_left_short(const ShadedMesh& shaded, std::span<const MeshPoint> points, std::span<double> answers) {
    const auto& [to_light, to_viewer, ambient, diffuse, specular, shininess] = shaded.lighting;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3d normal = mixed_normal(shaded.mesh, points[i]);
        const double cosine = dot(normal, to_light);
        const double along = dot(2 * cosine * normal - to_light, to_viewer);
        answers[i] = ambient + diffuse * std::max(0.0, cosine) +
                     (cosine > 0 && along > 0 ? specular * std::pow(along, shininess) : 0);
    }
}

ShadingMethod method(const std::string& name, const std::string& source,
                     void (*answer)(const ShadedMesh&, std::span<const MeshPoint>, std::span<double>)) {
    return {.name = name,
            .number = "double",
            .source = source,
            .prepare = {},
            .answer = [answer](const std::any&, std::span<const ShadedMesh> meshes, std::span<const MeshPoint> points,
                               std::span<double> answers) { answer(meshes[0], points, answers); }};
}

}  // namespace

double brightness(const Lighting& lighting, const Vec3d& normal) {
    const double cosine = dot(normal, lighting.to_light);
    if (!(cosine > 0)) return lighting.ambient;
    return lighting.ambient + lighting.diffuse * cosine +
           lighting.specular * phong_specular(normal, lighting.to_light, lighting.to_viewer, lighting.shininess);
}

double true_brightness(const Lighting& lighting, const Vec3d& normal) {
    return lighting.ambient + lighting.diffuse * std::max(0.0, dot(normal, lighting.to_light)) +
           lighting.specular * true_highlight({normal, lighting.to_light, lighting.to_viewer, lighting.shininess});
}

std::vector<ShadingMethod> shading_methods() {
    return {method("flat", "once a triangle, by the triangle's normal", flat),
            method("Gouraud", "H. Gouraud, Continuous Shading of Curved Surfaces, 1971", gouraud),
            method("Phong", "Bui Tuong Phong, Illumination for Computer Generated Pictures, 1975", phong),
            method("Phong, not unit again", "a frequent mistake", phong_left_short)};
}

ShadingMethod shading_at_a_hit(const std::string& name) {
    return method(name, "Bui Tuong Phong, 1975, by one hit's normals",
                  [](const ShadedMesh& shaded, std::span<const MeshPoint> points, std::span<double> answers) {
                      const BrightnessOf model = [&](const Vec3d& normal) {
                          return brightness(shaded.lighting, normal);
                      };
                      for (std::size_t i = 0; i < points.size(); ++i) {
                          const auto& [face, u, v] = points[i];
                          const auto [a, b, c] = shaded.mesh.faces[face];
                          const auto normal = [&](std::uint32_t vertex) { return vertex_normal(shaded.mesh, vertex); };
                          answers[i] = gouraud_and_phong({{normal(a), normal(b), normal(c)},
                                                          face_normal(shaded.mesh, face),
                                                          u,
                                                          v,
                                                          shaded.lighting.to_viewer},
                                                         model)
                                           .phong;
                      }
                  });
}

std::vector<SmoothSurface> smooth_surfaces() {
    const Lighting matte{
        .to_light = glm::normalize(Vec3d{-1, 1.2, 1.4}), .to_viewer = {0, 0, 1}, .specular = 0.3, .shininess = 5};
    Lighting shiny = matte;
    shiny.specular = 0.5;
    shiny.shininess = 100;
    constexpr double tube = 0.4;
    const auto sphere_normal = [](double x, double y) { return Vec3d{x, y, std::sqrt(1 - x * x - y * y)}; };
    const auto torus_normal = [](double x, double y) {
        const double out = std::hypot(x, y), slope = (out - 1) / tube;
        return Vec3d{slope * x / out, slope * y / out, std::sqrt(1 - slope * slope)};
    };
    return {{"matte sphere", "a wide highlight: shininess 5", icosphere, sphere_normal, 1, matte},
            {"shiny sphere", "a narrow highlight: shininess 100, narrower than a triangle of the coarse meshes",
             icosphere, sphere_normal, 1, shiny},
            {"shiny torus", "bent both ways, and more one way than the other",
             [](int level) { return torus(tube, level + 2); }, torus_normal, 1 + tube, shiny}};
}

std::vector<SeenAt> seen_places(const SmoothSurface& surface, std::size_t count, std::uint64_t seed) {
    constexpr double most_tilted = 0.7;  // a cosine; the octagon that approximates a circle reaches 0.92 of its radius
    std::vector<SeenAt> places;
    RandomSequence random(seed, 0);
    while (places.size() < count) {
        const auto x = cast<float>(random.between(-surface.reach, surface.reach));  // in floats, like rays
        const auto y = cast<float>(random.between(-surface.reach, surface.reach));
        if (surface.normal(x, y).z > most_tilted) places.push_back({x, y});  // the normal is NaN beside the surface
    }
    return places;
}

ShadingWorkload workload(const SmoothSurface& surface, int level, const std::vector<SeenAt>& places) {
    const auto mesh = std::make_shared<const Mesh>(with_vertex_normals(surface.mesh(level)));
    Scene scene;
    scene.materials = {{.name = "plain"}};
    scene.objects = {{.shape = mesh}};
    const auto accelerator = make_accelerator("auto", scene);
    ShadingWorkload result{.name = surface.name, .about = surface.about, .data = {{*mesh, surface.lighting}}};
    Traversal traversal;
    for (const auto& [x, y] : places) {
        const auto hit =
            accelerator->closest({.origin = convert<float>(Vec3d{x, y, 5}), .direction = {0, 0, -1}}, traversal);
        assert(hit && "every mesh covers what is not the rim");
        result.queries.push_back({hit->primitive.part, hit->u, hit->v});
    }
    return result;
}

std::vector<double> truth(const SmoothSurface& surface, const std::vector<SeenAt>& places) {
    std::vector<double> truths;
    for (const auto& [x, y] : places) truths.push_back(true_brightness(surface.lighting, surface.normal(x, y)));
    return truths;
}

}  // namespace raylab::lighting

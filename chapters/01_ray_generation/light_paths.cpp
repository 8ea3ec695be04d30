#include "light_paths.h"

#include "light_source.h"

#include "raylab/base/tiles.h"
#include "raylab/sampling/sequence.h"
#include "raylab/scene/picture_point.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/shading/surface_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace raylab::ray_generation {

namespace {

constexpr double pi = std::numbers::pi;
// A random direction about the normal, distributed as a diffuse surface reflects light: a point of the unit sphere that
// touches the surface (Lambert's cosine).
Vec3d diffuse_direction(const Vec3d& normal, RandomSequence& random) {
    return glm::normalize(normal + random.unit_vector());
}

// A light ray on its way through the scene.
struct Traveller {
    Vec3d position, direction;
    Color power;  // the part of the light's power that it carries
    bool at_light = true;
};

std::optional<SurfacePoint> next_surface(const Scene& scene, const Accelerator& accelerator,
                                         const Traveller& traveller) {
    Traversal traversal;
    const Ray ray = ray_from(traveller.position, traveller.direction, traveller.at_light ? 0.0f : skin);
    const auto hit = accelerator.closest(ray, traversal);
    if (!hit) return std::nullopt;
    return surface_point(scene, ray, *hit);
}

// Absorbs the ray, or lets it continue without changing the expectation: it survives with a probability equal to the
// reflectance.
bool survives(const Scene& scene, const SurfacePoint& point, Traveller& traveller, RandomSequence& random) {
    const Color reflectance = diffuse_color(scene, point, traveller.direction);
    const double chance = std::max({reflectance.x, reflectance.y, reflectance.z});
    if (random.next() >= chance) return false;
    const Vec3d normal = facing(point.normal, traveller.direction);
    traveller = {point.position, diffuse_direction(normal, random), traveller.power * reflectance / chance, false};
    return true;
}

// The distance along the ray at which it hits the eye's disk; absent where it passes by, or comes from behind.
std::optional<double> distance_to_eye(const CameraFrame& frame, double radius, const Traveller& traveller) {
    const double against_view = -dot(traveller.direction, frame.forward);
    if (!(against_view > 0)) return std::nullopt;
    const double distance = dot(traveller.position - frame.eye, frame.forward) / against_view;
    const Vec3d hit_found = traveller.position + distance * traveller.direction;
    if (!(distance > 0 && glm::length(hit_found - frame.eye) < radius)) return std::nullopt;
    return distance;
}

struct Arrival {
    int x, y;
    Color radiance;
};

// Converts power through a disk and a pixel to radiance: it is divided by the disk's area as seen from there and by the
// pixel's solid angle, (pixel width / distance)^2 cos at distance 1 / cos.
Color radiance_of(const Color& power, const CameraFrame& frame, double radius, double cos_view) {
    const double pixel_area = 4 * frame.half_width * frame.half_height / (frame.image.width * frame.image.height);
    return power / (pi * radius * radius * cos_view * pixel_area * cos_view * cos_view * cos_view);
}

std::optional<Arrival> arrival(const CameraFrame& frame, const Traveller& traveller, double radius) {
    const auto at = picture_point(frame, traveller.position);
    if (!at || !(at->x >= 0 && at->x < frame.image.width && at->y >= 0 && at->y < frame.image.height))
        return std::nullopt;
    const double cos_view = dot(glm::normalize(traveller.position - frame.eye), frame.forward);
    return Arrival{static_cast<int>(at->x), static_cast<int>(at->y),
                   radiance_of(traveller.power, frame, radius, cos_view)};
}

struct Piece {
    std::array<std::uint64_t, fates> ended{};
    std::uint64_t segments = 0;
    std::vector<Arrival> arrivals;
};

class Follower {
public:
    Follower(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
             const ForwardOptions& options)
        : scene_(scene), accelerator_(accelerator), frame_(frame), options_(options), light_(light_of(scene)) {}

    void follow(std::uint64_t ray, Piece& piece) const {
        RandomSequence random(options_.seed, ray);
        const Color share = 4 * pi * light_.intensity / static_cast<double>(options_.light_rays);
        Traveller traveller{light_.position, random.unit_vector(), share};
        ++piece.ended[static_cast<std::size_t>(fate(traveller, random, piece))];
    }

private:
    Fate fate(Traveller traveller, RandomSequence& random, Piece& piece) const {
        for (int segment = 0; segment < options_.longest_path; ++segment) {
            ++piece.segments;
            const auto point = next_surface(scene_, accelerator_, traveller);
            const auto eye = distance_to_eye(frame_, options_.eye_radius, traveller);
            const bool nearer = eye && (!point || *eye < glm::length(point->position - traveller.position));
            if (nearer) return intersect_eye(traveller, piece);
            if (!point) return Fate::left;
            if (!survives(scene_, *point, traveller, random)) return Fate::absorbed;
        }
        return Fate::absorbed;
    }

    Fate intersect_eye(const Traveller& traveller, Piece& piece) const {
        const auto arrived = arrival(frame_, traveller, options_.eye_radius);
        if (!arrived) return Fate::beside_picture;
        piece.arrivals.push_back(*arrived);
        return Fate::in_picture;
    }

    const Scene& scene_;
    const Accelerator& accelerator_;
    const CameraFrame& frame_;
    const ForwardOptions& options_;
    ShadingLight light_;
};

void add(Image& picture, const Arrival& arrived) {
    Pixel& pixel = picture.at(arrived.x, arrived.y);
    const Pixel more = to_pixel(arrived.radiance);
    pixel = {pixel.r + more.r, pixel.g + more.g, pixel.b + more.b};
}

}  // namespace

ForwardResult trace_forward(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                            const ForwardOptions& options) {
    constexpr std::size_t grain = 4096;
    const Follower follower(scene, accelerator, frame, options);
    // Each piece of rays has its own tally, and tallies are added in order, so that the sum does not depend on the
    // number of threads.
    std::vector<Piece> pieces((options.light_rays + grain - 1) / grain);
    for_each_piece(options.light_rays, grain, options.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t ray = begin; ray < end; ++ray) follower.follow(ray, pieces[begin / grain]);
    });
    ForwardResult result{.light_rays = options.light_rays, .picture = Image(frame.image.width, frame.image.height)};
    for (const Piece& piece : pieces) {
        for (std::size_t fate = 0; fate < fates; ++fate) result.ended[fate] += piece.ended[fate];
        result.segments += piece.segments;
        for (const Arrival& arrived : piece.arrivals) add(result.picture, arrived);
    }
    return result;
}

std::vector<Vec3d> light_path(const Scene& scene, const Accelerator& accelerator, std::uint64_t seed, std::uint64_t ray,
                              int longest_path) {
    RandomSequence random(seed, ray);
    const ShadingLight light = light_of(scene);
    Traveller traveller{light.position, random.unit_vector(), light.intensity};
    std::vector<Vec3d> stations{light.position};
    for (int segment = 0; segment < longest_path; ++segment) {
        const auto point = next_surface(scene, accelerator, traveller);
        stations.push_back(point ? point->position : traveller.position + 3.0 * traveller.direction);
        if (!point || !survives(scene, *point, traveller, random)) return stations;
    }
    return stations;
}

}  // namespace raylab::ray_generation

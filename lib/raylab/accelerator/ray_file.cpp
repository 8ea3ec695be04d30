#include "raylab/accelerator/ray_file.h"

#include "raylab/base/bytes.h"
#include "raylab/base/error.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

namespace raylab {

namespace {

constexpr std::size_t ray_bytes = 32;
constexpr std::size_t hit_bytes = 8;

bool is_finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string text(const Vec3f& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

void check(const Ray& ray, const std::function<Place()>& place) {
    const auto& [min, max] = ray.range;
    if (!is_finite(ray.origin)) throw Error(place(), "a finite origin", text(ray.origin));
    if (!is_finite(ray.direction)) throw Error(place(), "a finite direction", text(ray.direction));
    if (ray.direction == Vec3f(0, 0, 0)) throw Error(place(), "a direction that is not zero", text(ray.direction));
    if (!std::isfinite(min)) throw Error(place(), "a finite tmin", fmt::format("{}", min));
    if (!std::isfinite(max) && max != std::numeric_limits<float>::infinity())
        throw Error(place(), "a tmax that is finite or +infinity", fmt::format("{}", max));
}

}  // namespace

std::vector<Ray> rays_from_bytes(std::string_view bytes, const std::string& source) {
    const std::size_t count = bytes.size() / ray_bytes;
    const auto place = [&](std::size_t ray) { return Place{source, 0, "ray " + std::to_string(ray)}; };
    if (bytes.size() % ray_bytes != 0) throw Error(place(count), "32 bytes", std::to_string(bytes.size() % ray_bytes));
    std::vector<Ray> rays(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = [&](std::size_t n) {
            return number_at<float>(bytes, ray_bytes * i + 4 * n, std::endian::little);
        };
        rays[i] = {.origin = {number(0), number(1), number(2)},
                   .direction = {number(4), number(5), number(6)},
                   .range = {number(3), number(7)}};
        check(rays[i], [&] { return place(i); });
    }
    return rays;
}

std::string to_bytes(std::span<const Ray> rays) {
    std::string bytes;
    bytes.reserve(ray_bytes * rays.size());
    for (const auto& [o, d, range, leaving] : rays)
        for (const float number : {o.x, o.y, o.z, range.min, d.x, d.y, d.z, range.max})
            append_number(bytes, number, std::endian::little);
    return bytes;
}

std::string to_bytes(std::span<const HitRecord> hits) {
    std::string bytes;
    bytes.reserve(hit_bytes * hits.size());
    for (const auto& [triangle, t] : hits) {
        append_number(bytes, triangle, std::endian::little);
        append_number(bytes, t, std::endian::little);
    }
    return bytes;
}

}  // namespace raylab

#include "raylab/accelerator/ray_file.h"

#include "raylab/accelerator/check_ray.h"
#include "raylab/base/bytes.h"
#include "raylab/base/error.h"

#include <bit>
#include <cmath>

namespace raylab {

namespace {

constexpr std::size_t ray_bytes = 32;
constexpr std::size_t hit_bytes = 8;

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
        check_ray(rays[i], [&] { return place(i); });
        if (std::isinf(rays[i].range.min)) throw Error(place(i), "a finite tmin", "-inf");
    }
    return rays;
}

std::string to_bytes(std::span<const Ray> rays) {
    std::string bytes;
    bytes.reserve(ray_bytes * rays.size());
    for (const auto& ray : rays) {
        const auto& [o, d, range] = std::tie(ray.origin, ray.direction, ray.range);
        for (const float number : {o.x, o.y, o.z, range.min, d.x, d.y, d.z, range.max})
            append_number(bytes, number, std::endian::little);
    }
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

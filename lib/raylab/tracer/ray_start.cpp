#include "raylab/tracer/ray_start.h"

#include "raylab/base/error.h"
#include "raylab/number/next_float.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// A direction rounded to floats ends within 2^-23 of the distance from the light.
constexpr double short_of_light = 1 - 0x1p-21;

// Every coordinate is moved the way of the normal: by the bound of the point's error, then to the next float. So
// normal . (start - point) > error |normal|_1 >= error: the start lies on the ray's side of the tangent plane, surely, and
// less than a unit in the last place of each coordinate (and the error) from the point. Beyond, not merely not below: a
// point may be known exactly, and a ray that starts in a plane meets it at t = 0.
Vec3f beside(const SurfacePoint& surface, const Vec3d& normal) {
    const auto coordinate = [&](double x, double n) {
        return n == 0 ? cast<float>(x) : float_beyond(n > 0 ? x + surface.error : x - surface.error, n);
    };
    const Vec3d& p = surface.position;
    return {coordinate(p.x, normal.x), coordinate(p.y, normal.y), coordinate(p.z, normal.z)};
}

Vec3f origin(const SurfacePoint& surface, const Vec3d& direction, const RayStart& start, const Ray& arrived, double t) {
    if (start.offset == RayStart::Offset::error_bounded)
        return beside(surface, dot(surface.normal, direction) < 0 ? -surface.normal : surface.normal);
    if (start.point == RayStart::Point::along_ray) return arrived.origin + cast<float>(t) * arrived.direction;
    return convert<float>(surface.position);
}

double first_t(const Vec3f& point, const RayStart& start) {
    if (start.offset == RayStart::Offset::fixed) return start.amount;
    if (start.offset != RayStart::Offset::scaled) return 0;
    return start.amount * double{std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)})};
}

}  // namespace

Ray ray_from(const SurfacePoint& surface, const Vec3d& direction, double length, const RayStart& start, const Ray& arrived,
             double t) {
    const Vec3f point = origin(surface, direction, start, arrived, t);
    // As far as it would go from the point itself: a start that lies towards a light must not carry the ray past it.
    const double way = start.offset == RayStart::Offset::error_bounded
                           ? length - dot(convert<double>(point) - surface.position, direction)
                           : length;
    const float end = std::isinf(length) ? infinity : cast<float>(std::max(way, 0.0));
    return {point, convert<float>(direction), {cast<float>(first_t(point, start)), end},
            start.leaving == RayStart::Leaving::known ? surface.primitive : no_primitive};
}

Ray feeler(const SurfacePoint& surface, const Illumination& light, const RayStart& start, const Ray& arrived, double t) {
    return ray_from(surface, light.to_light, light.distance * short_of_light, start, arrived, t);
}

RayStart ray_start_from_words(const std::string& words) {
    if (words == "error_bounded") return {};
    if (words == "none") return {.offset = RayStart::Offset::none, .leaving = RayStart::Leaving::forgotten};
    const auto colon = words.find(':');
    const std::string kind = words.substr(0, colon), number = colon == words.npos ? "" : words.substr(colon + 1);
    double amount = 0;
    const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), amount);
    const bool read = problem == std::errc{} && end == number.data() + number.size() && amount >= 0 && std::isfinite(amount);
    if (read && kind == "fixed")
        return {.offset = RayStart::Offset::fixed, .amount = amount, .leaving = RayStart::Leaving::forgotten};
    if (read && kind == "scaled")
        return {.offset = RayStart::Offset::scaled, .amount = amount, .leaving = RayStart::Leaving::forgotten};
    throw Error("expected an offset (error_bounded, none, fixed:METRES, scaled:SHARE), found \"" + words + "\"");
}

}  // namespace raylab

#include "raylab/tracer/shading/ray_start.h"

#include "raylab/base/error.h"
#include "raylab/geometry/largest_coordinate.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

Vec3f origin(const SurfacePoint& surface, const RayStart& start, const Ray& arrived, double t) {
    if (start.point == RayStart::Point::along_ray) return arrived.origin + cast<float>(t) * arrived.direction;
    return convert<float>(surface.position);
}

double first_t(const Vec3f& point, const RayStart& start) {
    if (start.offset == RayStart::Offset::fixed) return start.amount;
    if (start.offset != RayStart::Offset::scaled) return 0;
    return start.amount * largest_coordinate(convert<double>(point));
}

}  // namespace

Ray ray_with_other_start(const SurfacePoint& surface, const Vec3d& direction, double length, const RayStart& start,
                         const Ray& arrived, double t) {
    const Vec3f point = origin(surface, start, arrived, t);
    const float end = std::isinf(length) ? std::numeric_limits<float>::infinity() : cast<float>(std::max(length, 0.0));
    return {point,
            convert<float>(direction),
            {cast<float>(first_t(point, start)), end},
            start.leaving == RayStart::Leaving::known ? surface.primitive : no_primitive};
}

RayStart ray_start_from_words(const std::string& words) {
    if (words == "error_bounded") return {};
    if (words == "none") return {.offset = RayStart::Offset::none, .leaving = RayStart::Leaving::forgotten};
    const auto colon = words.find(':');
    const std::string kind = words.substr(0, colon), number = colon == words.npos ? "" : words.substr(colon + 1);
    double amount = 0;
    const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), amount);
    const bool read =
        problem == std::errc{} && end == number.data() + number.size() && amount >= 0 && std::isfinite(amount);
    if (read && kind == "fixed")
        return {.offset = RayStart::Offset::fixed, .amount = amount, .leaving = RayStart::Leaving::forgotten};
    if (read && kind == "scaled")
        return {.offset = RayStart::Offset::scaled, .amount = amount, .leaving = RayStart::Leaving::forgotten};
    throw Error("expected an offset (error_bounded, none, fixed:METRES, scaled:SHARE), found \"" + words + "\"");
}

}  // namespace raylab

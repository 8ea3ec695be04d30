#include "raylab/accelerator/painters/plane_side.h"

#include "raylab/number/dyadic.h"
#include "raylab/number/enclosure.h"

namespace raylab {

namespace {

template <Scalar T>
Vec3<T> normal(const Triangle& t) {
    const auto a = convert<T>(t.a);
    return cross(convert<T>(t.b) - a, convert<T>(t.c) - a);
}

template <Scalar T>
T height(const Triangle& plane, const Vec3f& point) {
    return dot(normal<T>(plane), convert<T>(point) - convert<T>(plane.a));
}

// The first number type whose error bound permits a decision decides.
template <class HeightIn>
Sign decided(const HeightIn& height, DecisionCounts& decisions) {
    if (const auto known = sign(height.template operator()<Enclosure>())) return *known;
    ++decisions.exact;
    return sign(height.template operator()<Dyadic>());
}

}  // namespace

Sign side(const Triangle& plane, const Vec3f& point, DecisionCounts& decisions) {
    return decided([&]<Scalar T>() { return height<T>(plane, point); }, decisions);
}

// The crossing is at t = volume / determinant, as in triangle_intersection.h; its height times the determinant needs no
// division.
Sign side(const Triangle& plane, const Ray& ray, const Triangle& crossed, DecisionCounts& decisions) {
    const auto determinant = [&]<Scalar T>() { return dot(normal<T>(crossed), convert<T>(ray.direction)); };
    const auto scaled = [&]<Scalar T>() {
        const auto direction = convert<T>(ray.direction);
        const T volume = -height<T>(crossed, ray.origin);
        return determinant.template operator()<T>() * height<T>(plane, ray.origin) +
               volume * dot(normal<T>(plane), direction);
    };
    return decided(scaled, decisions) * decided(determinant, decisions);
}

bool has_plane(const Triangle& triangle) {
    const auto n = normal<Dyadic>(triangle);
    return sign(n.x) != Sign::zero || sign(n.y) != Sign::zero || sign(n.z) != Sign::zero;
}

}  // namespace raylab

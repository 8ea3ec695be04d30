#include "raylab/image/color_spaces.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace raylab {

namespace {

using glm::dvec3;

// The sRGB primaries as exact fractions, those that the authors of FLIP use; (1, 1, 1) becomes white.
const glm::dmat3 xyz_from_rgb(dvec3(10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382),  // of red
                              dvec3(8788810.0 / 24577794, 8788810.0 / 12288897, 8788810.0 / 73733382),   // of green
                              dvec3(4435075.0 / 24577794, 887015.0 / 12288897, 70074185.0 / 73733382));  // of blue
const glm::dmat3 rgb_from_xyz = glm::inverse(xyz_from_rgb);
const dvec3 white = xyz_from_rgb * dvec3(1);

// The formula that both spaces apply: to X, Y, Z relative to white, or to a curve of them.
dvec3 opponents(const dvec3& c) { return {116 * c.y - 16, 500 * (c.x - c.y), 200 * (c.y - c.z)}; }

dvec3 back(const dvec3& opponent) {
    const double y = (opponent.x + 16) / 116;
    return {y + opponent.y / 500, y, y - opponent.z / 200};
}

constexpr double delta = 6.0 / 29;

double lab_curve(double t) {  // a cube root, continued as a straight line near black
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

double inverse_lab_curve(double f) { return f > delta ? f * f * f : 3 * delta * delta * (f - 4.0 / 29); }

}  // namespace

dvec3 ycxcz_from_rgb(const dvec3& rgb) { return opponents(xyz_from_rgb * rgb / white); }

dvec3 rgb_from_ycxcz(const dvec3& ycxcz) { return rgb_from_xyz * (white * back(ycxcz)); }

dvec3 lab_from_rgb(const dvec3& rgb) {
    const dvec3 relative = xyz_from_rgb * rgb / white;
    return opponents({lab_curve(relative.x), lab_curve(relative.y), lab_curve(relative.z)});
}

dvec3 rgb_from_lab(const dvec3& lab) {
    const dvec3 f = back(lab);
    return rgb_from_xyz * (white * dvec3(inverse_lab_curve(f.x), inverse_lab_curve(f.y), inverse_lab_curve(f.z)));
}

}  // namespace raylab

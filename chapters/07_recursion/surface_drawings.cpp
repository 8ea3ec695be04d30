#include "surface_drawings.h"

#include "raylab/geometry/degree.h"
#include "raylab/report/plane/plane_sketch.h"
#include "raylab/tracer/refracted_direction.h"
#include "raylab/tracer/shading/fresnel.h"

#include <array>
#include <cmath>

namespace raylab::recursion {

namespace {

using namespace plane_ink;

PlanePoint scaled(PlanePoint p, double by) { return {p.x * by, p.y * by}; }
PlanePoint flat(const Vec3d& v) { return {v.x, v.y}; }

// A ray from the light in the water, and its two continuations at the surface, as wide as their shares.
void split(PlaneSketch& sketch, double angle, const char* color) {
    constexpr double ior = 1.33;
    const Vec3d direction{std::sin(angle), std::cos(angle), 0}, light{-1.6, -1, 0};
    const Vec3d at = light + direction * (-light.y / direction.y);
    const double share = fresnel(direction.y, ior, 1);
    const auto ray = [&](const Vec3d& from, const Vec3d& to, double part) {
        sketch.line(flat(from), flat(to), stroke(color, 0.6 + 5 * part));
    };
    ray(light, at, 1);
    ray(at, at + 2.0 * Vec3d{direction.x, -direction.y, 0}, share);
    if (const auto refracted = refracted_direction(direction, {0, -1, 0}, ior, 1))
        ray(at, at + 2.0 * *refracted, 1 - share);
}

}  // namespace

PlaneDrawing draw_hit() {
    PlaneSketch sketch;
    const double in = 50 * degree, out = std::asin(std::sin(in) / 1.5);
    const PlanePoint back{-std::sin(in), std::cos(in)}, mirrored{std::sin(in), std::cos(in)},
        through{std::sin(out), -std::cos(out)}, up{0, 1}, down{0, -1}, here{0, 0}, light{0.75, 2.3};
    sketch.polygon({{-3.2, 0}, {3.2, 0}, {3.2, -2.2}, {-3.2, -2.2}}, filled(pale_blue));
    sketch.line({-3.2, 0}, {3.2, 0}, stroke(black, 2));
    sketch.line(here, {0, 1.9}, stroke(grey, 1.5, dashed));
    sketch.line(here, {0, -1.8}, stroke(grey, 1.5, dashed));
    sketch.arrow(scaled(back, 2.7), here, stroke(black));
    sketch.arrow(here, scaled(mirrored, 2.5), stroke(blue));
    sketch.arrow(here, scaled(through, 1.9), stroke(green, 2.5, dashed));
    sketch.arrow(here, scaled(light, 0.93), stroke(grey, 2.5, dotted));
    sketch.arrow(here, up, stroke(black, 2));
    sketch.angle(up, back, 0.55, "*θ*_{1}");
    sketch.angle(up, mirrored, 0.62, "*θ*_{1}");
    sketch.angle(down, through, 0.75, "*θ*_{2}");
    sketch.light(light);
    sketch.dot(here, 4, black);
    sketch.text({-2.5, 1.85}, "the ray, direction **D**", black);
    sketch.text({-0.12, 1.05}, "**N**", black, Anchor::right);
    sketch.text({1.5, 1.7}, "mirrored: **R**", blue);
    sketch.text({0.95, 2.25}, "shadow ray: **L**", grey);
    sketch.text({1.05, -1.5}, "transmitted: **T**", green);
    sketch.text({-2.9, 0.14}, "index *n*_{1}");
    sketch.text({-2.9, -0.3}, "index *n*_{2}");
    return sketch.drawing({-3, -2}, {3, 2.6}, 640, 480);
}

PlaneDrawing draw_snell_vectors() {
    PlaneSketch sketch;
    const double in = 50 * degree, sine = std::sin(in), cosine = std::cos(in), part = sine / 1.5,
                 rest = std::sqrt(1 - part * part);
    const PlanePoint here{0, 0};
    sketch.polygon({{-2, 0}, {2, 0}, {2, -2}, {-2, -2}}, filled(pale_blue));
    sketch.circle(here, 1, stroke("#9a9a9a", 1.5, dotted));
    sketch.line({-2, 0}, {2, 0}, stroke(black, 2));
    sketch.line({-sine, 0}, {-sine, cosine}, stroke(grey, 1.5, dashed));
    sketch.line({-sine, cosine}, {0, cosine}, stroke(grey, 1.5, dashed));
    sketch.arrow({-sine, cosine}, here, stroke(black));
    sketch.arrow(here, {0, 1}, stroke(black, 2));
    sketch.arrow(here, {sine, cosine}, stroke(blue));
    sketch.arrow(here, {part, 0}, stroke(vermilion, 3.5));
    sketch.arrow({part, 0}, {part, -rest}, stroke(vermilion, 2, dashed));
    sketch.arrow(here, {part, -rest}, stroke(green));
    sketch.angle({0, 1}, {-sine, cosine}, 0.27, "*θ*_{1}");
    sketch.angle({0, -1}, {part, -rest}, 0.36, "*θ*_{2}");
    sketch.text({-0.4, 0.22}, "**D**", black, Anchor::right);
    sketch.text({0.04, 1.03}, "**N**", black);
    sketch.text({sine + 0.04, cosine}, "**R** = **D** + 2*c***N**", blue);
    sketch.text({-0.4, cosine + 0.04}, "sin *θ*_{1}", grey, Anchor::center);
    sketch.text({-sine - 0.03, cosine / 2}, "*c* = cos *θ*_{1}", grey, Anchor::right);
    sketch.text({part + 0.05, 0.05}, "**A**, of length sin *θ*_{2}", vermilion);
    sketch.text({part + 0.05, -0.5}, "−√(1 − **A**·**A**) **N**", vermilion);
    sketch.text({0.36, -0.78}, "**T**", green, Anchor::right);
    sketch.text({-1.4, 0.05}, "index *n*_{1}");
    sketch.text({-1.4, -0.11}, "index *n*_{2}");
    return sketch.drawing({-1.45, -1.15}, {1.45, 1.15}, 640, 500);
}

PlaneDrawing draw_snell() {
    PlaneSketch sketch;
    sketch.polygon({{-4, 0}, {4, 0}, {4, -2}, {-4, -2}}, filled(pale_blue));
    sketch.line({-4, 0}, {4, 0}, stroke(black, 1.5));
    constexpr std::array colors = {black, blue, "#56b4e9", green, "#e69f00", vermilion, "#cc79a7"};
    constexpr std::array angles = {0.0, 15.0, 30.0, 42.0, 47.5, 55.0, 65.0};
    for (std::size_t i = 0; i < angles.size(); ++i) split(sketch, angles[i] * degree, colors[i]);
    sketch.dot({-1.6, -1}, 6, black);
    sketch.text({-2.4, 0.85}, "air, *n* = 1");
    sketch.text({2.45, -1.28}, "water, *n* = 1.33", black, Anchor::right);
    sketch.text({2.45, 0.07}, "all reflected beyond 48.75°", black, Anchor::right);
    return sketch.drawing({-2.5, -1.35}, {2.5, 1}, 720, 345);
}

PlaneDrawing draw_mirrored_into_facet() {
    PlaneSketch sketch;
    const double lean = 14 * degree, slant = 72 * degree;
    const Vec3d direction{std::sin(slant), -std::cos(slant), 0}, facet{0, 1, 0},
        smooth{std::sin(lean), std::cos(lean), 0};
    const auto mirrored = [&](const Vec3d& n) { return flat(direction - 2 * dot(direction, n) * n); };
    const PlanePoint here{0, 0};
    sketch.polygon({{-2.4, -0.6}, {-1.2, 0}, {0.6, 0}, {2.4, -0.9}, {2.4, -1.5}, {-2.4, -1.5}}, filled(pale_grey));
    sketch.path({{-2.4, -0.6}, {-1.2, 0}, {0.6, 0}, {2.4, -0.9}}, stroke(black, 2.5));
    sketch.arrow(scaled(flat(direction), -1.9), here, stroke(black));
    sketch.arrow(here, scaled(flat(facet), 0.9), stroke(blue, 2));
    sketch.arrow(here, scaled(flat(smooth), 0.9), stroke(vermilion, 2, dashed));
    sketch.arrow(here, scaled(mirrored(facet), 1.7), stroke(blue));
    sketch.arrow(here, scaled(mirrored(smooth), 1.4), stroke(vermilion, 2.5, dashed));
    sketch.dot(here, 4, black);
    sketch.text({-1.85, 0.66}, "**D**", black);
    sketch.text({-0.06, 0.95}, "the facet's normal", blue, Anchor::right);
    sketch.text({0.27, 0.9}, "the interpolated normal", vermilion);
    sketch.text({0.72, 0.6}, "by the facet's normal", blue);
    sketch.text({0.35, -0.42}, "by the interpolated one:", vermilion);
    sketch.text({0.35, -0.58}, "into the surface", vermilion);
    return sketch.drawing({-2, -0.85}, {2, 1.3}, 640, 360);
}

}  // namespace raylab::recursion

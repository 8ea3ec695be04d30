#include "surface_drawings.h"

#include "raylab/report/plane/plane_angle.h"
#include "raylab/tracer/refracted_direction.h"
#include "raylab/tracer/shading/fresnel.h"

#include <array>
#include <cmath>
#include <numbers>

namespace raylab::recursion {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr const char *black = "#000000", *blue = "#0072b2", *green = "#009e73", *grey = "#6b6b6b", *red = "#d55e00",
                     *glass = "#e3f1fb";
using Dash = PlaneStyle::Dash;

PlaneStyle stroke(const char* color, double width = 2.5, Dash dash = Dash::solid) {
    return {.line = color, .width = width, .dash = dash};
}

// A drawing that grows mark by mark.
class Sketch {
public:
    Sketch(PlanePoint low, PlanePoint high, int width, int height)
        : drawing_{.title = "", .low = low, .high = high, .width = width, .height = height} {}

    void fill(const std::vector<PlanePoint>& corners, const char* color) {
        drawing_.marks.push_back(PlaneDrawing::Figure{PlanePolygon{corners}, {.line = "", .fill = color}});
    }
    void line(PlanePoint from, PlanePoint to, const PlaneStyle& style) {
        drawing_.marks.push_back(PlaneDrawing::Path{{from, to}, style});
    }
    void arrow(PlanePoint from, PlanePoint to, const PlaneStyle& style) {
        drawing_.marks.push_back(PlaneDrawing::Arrow{from, to, style});
    }
    void angle(PlanePoint from, PlanePoint to, double radius, const std::string& words) {
        const auto arc = angle_arc({0, 0}, from, to, radius, stroke(grey, 1.5));
        drawing_.marks.push_back(arc);
        drawing_.marks.push_back(beside_arc(arc, words, 16));
    }
    void text(PlanePoint at, const std::string& words, const char* color, Anchor anchor = Anchor::left) {
        drawing_.marks.push_back(
            PlaneDrawing::Text{.at = at, .words = words, .height = 12, .color = color, .anchor = anchor});
    }
    /// Words on a coloured ground, without a rim.
    void note(PlanePoint at, const std::string& words, Anchor anchor = Anchor::left) {
        drawing_.marks.push_back(
            PlaneDrawing::Text{.at = at, .words = words, .height = 11, .color = "#444444", .anchor = anchor});
    }
    void add(PlaneDrawing::Mark mark) { drawing_.marks.push_back(std::move(mark)); }

    PlaneDrawing drawing() const { return drawing_; }

private:
    PlaneDrawing drawing_;
};

PlanePoint scaled(PlanePoint p, double by) { return {p.x * by, p.y * by}; }
PlanePoint flat(const Vec3d& v) { return {v.x, v.y}; }

// A ray from the light in the water, and its two continuations at the surface, as wide as their shares.
void split(Sketch& sketch, double angle, const char* color) {
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
    Sketch sketch({-3, -2}, {3, 2.6}, 640, 480);
    const double in = 50 * degree, out = std::asin(std::sin(in) / 1.5);
    const PlanePoint back{-std::sin(in), std::cos(in)}, mirrored{std::sin(in), std::cos(in)},
        through{std::sin(out), -std::cos(out)}, up{0, 1}, down{0, -1}, here{0, 0}, light{0.75, 2.3};
    sketch.fill({{-3.2, 0}, {3.2, 0}, {3.2, -2.2}, {-3.2, -2.2}}, glass);
    sketch.line({-3.2, 0}, {3.2, 0}, stroke(black, 2));
    sketch.line(here, {0, 1.9}, stroke(grey, 1.5, Dash::dashed));
    sketch.line(here, {0, -1.8}, stroke(grey, 1.5, Dash::dashed));
    sketch.arrow(scaled(back, 2.7), here, stroke(black));
    sketch.arrow(here, scaled(mirrored, 2.5), stroke(blue));
    sketch.arrow(here, scaled(through, 1.9), stroke(green, 2.5, Dash::dashed));
    sketch.arrow(here, {0.93 * light.x, 0.93 * light.y}, stroke(grey, 2.5, Dash::dotted));
    sketch.arrow(here, up, stroke(black, 2));
    sketch.angle(up, back, 0.55, "*θ*_{1}");
    sketch.angle(up, mirrored, 0.62, "*θ*_{1}");
    sketch.angle(down, through, 0.75, "*θ*_{2}");
    sketch.add(PlaneDrawing::Dot{light, 9, "#444444"});
    sketch.add(PlaneDrawing::Dot{light, 7, "#ffd93b"});
    sketch.add(PlaneDrawing::Dot{here, 4, black});
    sketch.text({-2.5, 1.85}, "the ray, direction **D**", black);
    sketch.text({-0.12, 1.05}, "**N**", black, Anchor::right);
    sketch.text({1.5, 1.7}, "mirrored: **R**", blue);
    sketch.text({0.95, 2.25}, "shadow ray: **L**", grey);
    sketch.text({1.05, -1.5}, "transmitted: **T**", green);
    sketch.note({-2.9, 0.14}, "index *n*_{1}");
    sketch.note({-2.9, -0.3}, "index *n*_{2}");
    return sketch.drawing();
}

PlaneDrawing draw_snell_vectors() {
    Sketch sketch({-1.45, -1.15}, {1.45, 1.15}, 640, 500);
    const double in = 50 * degree, sine = std::sin(in), cosine = std::cos(in), part = sine / 1.5,
                 rest = std::sqrt(1 - part * part);
    const PlanePoint here{0, 0};
    sketch.fill({{-2, 0}, {2, 0}, {2, -2}, {-2, -2}}, glass);
    sketch.add(PlaneDrawing::Figure{PlaneCircle{here, 1}, stroke("#9a9a9a", 1.5, Dash::dotted)});
    sketch.line({-2, 0}, {2, 0}, stroke(black, 2));
    sketch.line({-sine, 0}, {-sine, cosine}, stroke(grey, 1.5, Dash::dashed));
    sketch.line({-sine, cosine}, {0, cosine}, stroke(grey, 1.5, Dash::dashed));
    sketch.arrow({-sine, cosine}, here, stroke(black));
    sketch.arrow(here, {0, 1}, stroke(black, 2));
    sketch.arrow(here, {sine, cosine}, stroke(blue));
    sketch.arrow(here, {part, 0}, stroke(red, 3.5));
    sketch.arrow({part, 0}, {part, -rest}, stroke(red, 2, Dash::dashed));
    sketch.arrow(here, {part, -rest}, stroke(green));
    sketch.angle({0, 1}, {-sine, cosine}, 0.27, "*θ*_{1}");
    sketch.angle({0, -1}, {part, -rest}, 0.36, "*θ*_{2}");
    sketch.text({-0.4, 0.22}, "**D**", black, Anchor::right);
    sketch.text({0.04, 1.03}, "**N**", black);
    sketch.text({sine + 0.04, cosine}, "**R** = **D** + 2*c***N**", blue);
    sketch.text({-0.4, cosine + 0.04}, "sin *θ*_{1}", grey, Anchor::center);
    sketch.text({-sine - 0.03, cosine / 2}, "*c* = cos *θ*_{1}", grey, Anchor::right);
    sketch.text({part + 0.05, 0.05}, "**A**, of length sin *θ*_{2}", red);
    sketch.text({part + 0.05, -0.5}, "−√(1 − **A**·**A**) **N**", red);
    sketch.text({0.36, -0.78}, "**T**", green, Anchor::right);
    sketch.note({-1.4, 0.05}, "index *n*_{1}");
    sketch.note({-1.4, -0.11}, "index *n*_{2}");
    return sketch.drawing();
}

PlaneDrawing draw_snell() {
    Sketch sketch({-2.5, -1.35}, {2.5, 1}, 720, 345);
    sketch.fill({{-4, 0}, {4, 0}, {4, -2}, {-4, -2}}, glass);
    sketch.line({-4, 0}, {4, 0}, stroke(black, 1.5));
    constexpr std::array colors = {black, blue, "#56b4e9", green, "#e69f00", red, "#cc79a7"};
    constexpr std::array angles = {0.0, 15.0, 30.0, 42.0, 47.5, 55.0, 65.0};
    for (std::size_t i = 0; i < angles.size(); ++i) split(sketch, angles[i] * degree, colors[i]);
    sketch.add(PlaneDrawing::Dot{{-1.6, -1}, 6, black});
    sketch.note({-2.4, 0.85}, "air, *n* = 1");
    sketch.note({-2.4, -0.12}, "water, *n* = 1.33");
    sketch.note({2.45, 0.07}, "all reflected beyond 48.75°", Anchor::right);
    return sketch.drawing();
}

PlaneDrawing draw_mirrored_into_facet() {
    Sketch sketch({-2, -0.85}, {2, 1.3}, 640, 360);
    const double lean = 14 * degree, slant = 72 * degree;
    const Vec3d direction{std::sin(slant), -std::cos(slant), 0}, facet{0, 1, 0},
        smooth{std::sin(lean), std::cos(lean), 0};
    const auto mirrored = [&](const Vec3d& n) { return flat(direction - 2 * dot(direction, n) * n); };
    const PlanePoint here{0, 0};
    sketch.fill({{-2.4, -0.6}, {-1.2, 0}, {0.6, 0}, {2.4, -0.9}, {2.4, -1.5}, {-2.4, -1.5}}, "#ececec");
    sketch.add(PlaneDrawing::Path{{{-2.4, -0.6}, {-1.2, 0}, {0.6, 0}, {2.4, -0.9}}, stroke(black, 2.5)});
    sketch.arrow(scaled(flat(direction), -1.9), here, stroke(black));
    sketch.arrow(here, scaled(flat(facet), 0.9), stroke(blue, 2));
    sketch.arrow(here, scaled(flat(smooth), 0.9), stroke(red, 2, Dash::dashed));
    sketch.arrow(here, scaled(mirrored(facet), 1.7), stroke(blue));
    sketch.arrow(here, scaled(mirrored(smooth), 1.4), stroke(red, 2.5, Dash::dashed));
    sketch.add(PlaneDrawing::Dot{here, 4, black});
    sketch.text({-1.85, 0.66}, "**D**", black);
    sketch.text({-0.06, 0.95}, "the facet's normal", blue, Anchor::right);
    sketch.text({0.27, 0.9}, "the interpolated normal", red);
    sketch.text({0.72, 0.6}, "by the facet's normal", blue);
    sketch.text({0.35, -0.42}, "by the interpolated one:", red);
    sketch.text({0.35, -0.58}, "into the surface", red);
    return sketch.drawing();
}

}  // namespace raylab::recursion

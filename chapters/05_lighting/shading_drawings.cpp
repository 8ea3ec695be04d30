#include "shading_drawings.h"

#include "raylab/geometry/degree.h"
#include "raylab/report/plane/plane_angle.h"
#include "raylab/report/plane/plane_sketch.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::lighting {

namespace {

using namespace plane_ink;

// A direction this many degrees from the vertical, to the right.
PlanePoint leaning(double degrees) { return {std::sin(degrees * degree), std::cos(degrees * degree)}; }
PlanePoint scaled(PlanePoint p, double by) { return {p.x * by, p.y * by}; }
PlanePoint moved(PlanePoint p, PlanePoint by) { return {p.x + by.x, p.y + by.y}; }

// A plate of glass or of other matter with the light that arrives, and the directions that it takes from there.
void matter(PlaneSketch& sketch, double x, const std::string& name, const std::vector<double>& directions,
            const char* color) {
    const double inside = std::asin(std::sin(40 * degree) / 1.5);  // Snell's law, chapter 07
    const PlanePoint here{x, 0}, behind{x + 0.5 * std::tan(inside), -0.5};
    sketch.rectangle({x - 1.1, -0.5}, {x + 1.1, 0}, filled(pale_grey));
    sketch.line({x - 1.1, 0}, {x + 1.1, 0}, stroke(black, 2));
    sketch.arrow(moved(here, scaled(leaning(-40), 1.5)), here, stroke(orange, 3.5));
    for (const double direction : directions) {
        const bool through = std::abs(direction) > 90;
        const PlanePoint from = through ? behind : here;
        sketch.arrow(from, moved(from, scaled(leaning(direction), directions.size() > 1 ? 0.75 : 1.1)),
                     stroke(color, directions.size() > 1 ? 2 : 3));
        if (through) sketch.line(here, from, stroke(color, 2));
    }
    sketch.text({x, -1.75}, name, black, Anchor::center);
}

// A beam one unit wide that comes from this direction, and what it covers of the surface.
void beam(PlaneSketch& sketch, double x, double degrees, const std::string& words) {
    const PlanePoint toward = leaning(-degrees);
    const double covered = 1 / std::cos(degrees * degree);
    const PlanePoint left{x - covered / 2, 0}, right{x + covered / 2, 0};
    sketch.polygon({left, right, moved(right, scaled(toward, 2.2)), moved(left, scaled(toward, 2.2))},
                   filled(pale_orange));
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        const PlanePoint at{std::lerp(left.x, right.x, share), 0};
        sketch.arrow(moved(at, scaled(toward, 2.1)), at, stroke(orange, 2));
    }
    sketch.line(left, right, stroke(vermilion, 6));
    sketch.text({x, -0.4}, words, vermilion, Anchor::center);
}

// A floor five wide, and L at three of its points; what arrives as a stroke's width.
template <class ToLight, class Width>
void lit_floor(PlaneSketch& sketch, double left, const std::string& words, const ToLight& to_light,
               const Width& width) {
    sketch.rectangle({left, -0.2}, {left + 5, 0}, filled(pale_grey));
    sketch.line({left, 0}, {left + 5, 0}, stroke(black, 2));
    for (const double x : {left + 0.7, left + 2.5, left + 4.3}) {
        const PlanePoint tip = moved({x, 0}, to_light(x));
        sketch.arrow({x, 0}, tip, stroke(orange, width(x)));
        sketch.text(moved(tip, {0, 0.1}), "**L**", black, Anchor::center);
    }
    sketch.text({left + 2.5, -0.6}, words, black, Anchor::center);
}

}  // namespace

PlaneDrawing draw_light_meets_matter() {
    PlaneSketch sketch;
    matter(sketch, 0, "mirrored", {40}, blue);
    matter(sketch, 2.5, "diffuse", {-70, -45, -15, 15, 45, 70}, blue);
    matter(sketch, 5, "transmitted", {140}, green);
    matter(sketch, 7.5, "translucent", {110, 135, 165, -165, -135, -110}, green);
    matter(sketch, 10, "absorbed", {}, black);
    sketch.text({10, -0.35}, "heat", vermilion, Anchor::center);
    return sketch.drawing({-1.2, -1.9}, {11.2, 1.25}, 900, 250);
}

PlaneDrawing draw_point_and_distant() {
    PlaneSketch sketch;
    const PlanePoint light{2.5, 2.1};
    const auto distance = [&](double x) { return std::hypot(light.x - x, light.y); };
    sketch.light(light);
    lit_floor(
        sketch, 0, "a point light",
        [&](double x) {
            return scaled({light.x - x, light.y}, 1.2 / distance(x));
        },
        [&](double x) { return 18 / (distance(x) * distance(x)); });
    lit_floor(
        sketch, 6.5, "a distant light", [&](double) { return scaled(leaning(30), 1.2); }, [](double) { return 3.0; });
    return sketch.drawing({-0.2, -0.8}, {11.7, 2.4}, 760, 205);
}

PlaneDrawing draw_lambert() {
    PlaneSketch sketch;
    sketch.line({-2, 0}, {6, 0}, stroke(black, 2));
    beam(sketch, -0.4, 0, "1");
    beam(sketch, 3.6, 60, "1 / cos 60° = 2");
    sketch.line({3.6, 0}, {3.6, 1.6}, stroke(grey, 1.5, dashed));
    const auto arc = angle_arc({3.6, 0}, {3.6, 1}, moved({3.6, 0}, leaning(-60)), 1.15, stroke(black, 2));
    sketch.add({arc, beside_arc(arc, "*θ*", 15)});
    sketch.text({3.68, 1.5}, "**N**");
    return sketch.drawing({-1.3, -0.6}, {5.2, 2.1}, 720, 310);
}

PlaneDrawing draw_vectors() {
    PlaneSketch sketch;
    const PlanePoint light = leaning(-48), mirrored = leaning(48), viewer = leaning(72), here{0, 0};
    const double along = std::cos(48 * degree);
    sketch.rectangle({-2, -0.16}, {2, 0}, filled(pale_grey));
    sketch.line({-2, 0}, {2, 0}, stroke(black, 2));
    sketch.line(light, mirrored, stroke(grey, 1.5, dashed));
    sketch.arrow(here, {0, 1.15}, stroke(black));
    sketch.arrow(here, light, stroke(orange, 3));
    sketch.arrow(here, mirrored, stroke(blue));
    sketch.arrow(here, viewer, stroke(green));
    sketch.angle({0, 1}, light, 0.32, "*θ*");
    sketch.angle({0, 1}, mirrored, 0.36, "*θ*");
    sketch.angle(mirrored, viewer, 0.5, "*α*");
    sketch.dot({0, along}, 4, grey);
    sketch.text({0.04, 1.12}, "**N**");
    sketch.text(moved(light, {-0.03, 0.05}), "**L**", black, Anchor::right);
    sketch.text(moved(mirrored, {0.04, 0.03}), "**R**", blue);
    sketch.text(moved(viewer, {0.05, -0.02}), "**V**", green);
    sketch.text({0.04, along + 0.05}, "(**N**·**L**) **N**", grey);
    return sketch.drawing({-1.35, -0.15}, {1.35, 1.25}, 640, 360);
}

PlaneDrawing draw_lobes() {
    PlaneSketch sketch;
    const PlanePoint here{0, 0};
    const double mirror = 40;
    sketch.line({-2, 0}, {2, 0}, stroke(black, 2));
    const auto lobe = [&](double exponent, const PlaneStyle& style, PlanePoint at, const std::string& words) {
        std::vector<PlanePoint> rim;
        for (int off = -90; off <= 90; ++off) {
            const double degrees = mirror + off;
            if (std::abs(degrees) <= 90)
                rim.push_back(scaled(leaning(degrees), std::pow(std::cos(off * degree), exponent)));
        }
        sketch.path(rim, style);
        sketch.text(at, words, style.line.c_str());
    };
    sketch.arrow(moved(here, leaning(-mirror)), here, stroke(orange, 3));
    sketch.arrow(here, scaled(leaning(mirror), 1.12), stroke(grey, 1.5, dashed));
    lobe(2, stroke(green, 2.5, dashed), {0.9, 0.5}, "*n* = 2, dashed");
    lobe(10, stroke(blue), {0.9, 0.36}, "*n* = 10, solid");
    lobe(100, stroke(vermilion, 2.5, dotted), {0.9, 0.22}, "*n* = 100, dotted");
    sketch.text({0.76, 0.86}, "**R**", grey);
    sketch.text({-0.62, 0.84}, "light", orange, Anchor::right);
    return sketch.drawing({-0.9, -0.05}, {1.5, 1}, 640, 300);
}

PlaneDrawing draw_interpolation() {
    PlaneSketch sketch;
    const auto side = [&](double x, const std::string& title, bool of_normals) {
        const PlanePoint a{x - 1.5, 0}, b{x + 1.5, 0};
        sketch.line(a, b, stroke(black, 3));
        for (int i = 0; i <= 6; ++i) {
            const double share = i / 6.0;
            const PlanePoint at{std::lerp(a.x, b.x, share), 0};
            const bool is_corner = i == 0 || i == 6;
            const double mixed = std::lerp(-35.0, 35.0, share);  // as the unit vector of the mean, nearly
            if (is_corner || of_normals)
                sketch.arrow(at, moved(at, scaled(leaning(mixed), 0.85)),
                             is_corner ? stroke(black) : stroke(blue, 2, dashed));
            if (!of_normals) {
                const double grey_level = std::lerp(60.0, 215.0, share);
                sketch.dot(at, is_corner ? 13 : 9, black);
                sketch.dot(at, is_corner ? 12 : 8, fmt::format("#{0:02x}{0:02x}{0:02x}", static_cast<int>(grey_level)));
            }
        }
        sketch.text({x, -0.5}, title, black, Anchor::center);
    };
    side(0, "Gouraud: two colours, mixed between", false);
    side(4.6, "Phong: two normals, mixed between", true);
    return sketch.drawing({-2.2, -0.6}, {6.8, 1}, 900, 220);
}

}  // namespace raylab::lighting

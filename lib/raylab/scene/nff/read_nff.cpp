#include "raylab/scene/nff/read_nff.h"

#include "raylab/scene/camera.h"
#include "raylab/scene/check_shape.h"
#include "raylab/scene/nff/patch.h"
#include "raylab/scene/nff/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace raylab {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Reader {
public:
    Reader(std::string_view text, const std::string& file) : tokens_(text, file) { scene_.source = file; }

    Scene read() {
        while (!tokens_.at_end()) read_entity(std::string(tokens_.word("an entity")));
        if (!view_) tokens_.word("a view (v)");  // the file has ended without one, so this throws
        camera_frame(scene_.camera, scene_.image, to_string(*view_));
        for (const auto light : lights_without_color_)
            scene_.lights[light].color = Color{1, 1, 1} / std::sqrt(static_cast<double>(scene_.lights.size()));
        return std::move(scene_);
    }

private:
    void read_entity(const std::string& name) {
        using Read = void (Reader::*)();
        static const std::map<std::string, Read> readers{{"v", &Reader::read_view},    {"b", &Reader::read_background},
                                                         {"l", &Reader::read_light},   {"f", &Reader::read_fill},
                                                         {"c", &Reader::read_cone},    {"s", &Reader::read_sphere},
                                                         {"p", &Reader::read_polygon}, {"pp", &Reader::read_patch}};
        const auto reader = readers.find(name);
        if (reader == readers.end())
            throw Error(tokens_.place(), "an entity (v, b, l, f, c, s, p, pp)", '"' + name.substr(0, 60) + '"');
        (this->*reader->second)();
    }

    void read_view() {
        if (view_) throw Error(tokens_.place(), "one view", fmt::format("a second (first at {})", to_string(*view_)));
        view_ = tokens_.place();
        expect("from");
        scene_.camera.position = tokens_.vector("the point of from");
        expect("at");
        scene_.camera.target = tokens_.vector("the point of at");
        expect("up");
        scene_.camera.up = tokens_.vector("the direction of up");
        expect("angle");
        scene_.camera.projection = Perspective{tokens_.number("the angle in degrees")};
        expect("hither");
        tokens_.number_from(0, infinity, "the distance of hither");
        expect("resolution");
        scene_.image.width = tokens_.whole(1, largest_image_side, "the resolution in x");
        scene_.image.height = tokens_.whole(1, largest_image_side, "the resolution in y");
    }

    void expect(const std::string& word) {
        const std::string found(tokens_.word('"' + word + '"'));
        if (found != word) throw Error(tokens_.place(), '"' + word + '"', '"' + found.substr(0, 60) + '"');
    }

    Color read_color(const std::string& what, double largest) {
        const double red = tokens_.number_from(0, largest, "red of " + what);
        const double green = tokens_.number_from(0, largest, "green of " + what);
        const double blue = tokens_.number_from(0, largest, "blue of " + what);
        return {red, green, blue};
    }

    void read_background() { scene_.background.color = read_color("the background", 1); }

    void read_light() {
        scene_.lights.push_back({.kind = PointLight{tokens_.vector("the position of a light")}});
        if (tokens_.number_follows())
            scene_.lights.back().color = read_color("a light", infinity);
        else
            lights_without_color_.push_back(scene_.lights.size() - 1);
    }

    void read_fill() {
        const auto place = tokens_.place();
        const auto color = read_color("a fill", 1);
        const double diffuse = tokens_.number_from(0, infinity, "Kd of a fill");
        const double specular = tokens_.number_from(0, infinity, "Ks of a fill");
        const double shine = tokens_.number_from(0, infinity, "Shine of a fill");
        const double transmittance = tokens_.number_from(0, 1, "T of a fill");
        const double ior = tokens_.number_from(0, infinity, "the index of refraction of a fill");
        if (ior == 0 && transmittance > 0)
            throw Error(tokens_.place(), "an index of refraction above 0 where T is above 0", "0");
        const double sent_on = std::max(1.0, specular + transmittance);
        const double kr = specular / sent_on;
        scene_.materials.push_back({.name = fmt::format("fill of line {}", place.line),
                                    .diffuse = color * diffuse,
                                    .specular = Color{1, 1, 1} * specular,
                                    .shininess = shine,
                                    .kr = kr,
                                    .kt = std::min(transmittance / sent_on, 1 - kr),  // the rounded values may exceed 1
                                    .ior = ior > 0 ? ior : 1});
    }

    void read_sphere() {
        const auto place = tokens_.place();
        const auto center = convert<float>(tokens_.vector("the center of a sphere"));
        const double radius = tokens_.number("the radius of a sphere");
        add(Sphere{center, cast<float>(std::abs(radius))}, radius, "sphere", place);
    }

    void read_cone() {
        const auto place = tokens_.place();
        const auto base = convert<float>(tokens_.vector("the base of a cone"));
        const double base_radius = tokens_.number("the base radius of a cone");
        const auto apex = convert<float>(tokens_.vector("the apex of a cone"));
        const double apex_radius = tokens_.number("the apex radius of a cone");
        if (std::min(base_radius, apex_radius) < 0 && std::max(base_radius, apex_radius) > 0)
            throw Error(tokens_.place(), "radii of one sign", fmt::format("{} and {}", base_radius, apex_radius));
        const float at_base = cast<float>(std::abs(base_radius));
        const float at_apex = cast<float>(std::abs(apex_radius));
        const double sign = base_radius + apex_radius;
        if (at_base == at_apex && at_base > 0)
            add(Cylinder{base, apex, at_base}, sign, "cylinder", place);
        else
            add(Cone{base, apex, at_base, at_apex}, sign, "cone", place);
    }

    void read_polygon() {
        const auto place = tokens_.place();
        constexpr std::size_t min_bytes = 6;  // of three digits, each after a blank
        std::vector<Vec3f> vertices(read_count(min_bytes));
        for (auto& vertex : vertices) vertex = convert<float>(tokens_.vector("a vertex of a polygon"));
        if (vertices.size() == 3)
            add(Triangle{vertices[0], vertices[1], vertices[2]}, 1, "triangle", place);
        else
            add(Polygon{std::move(vertices)}, 1, "polygon", place);
    }

    void read_patch() {
        const auto place = tokens_.place();
        constexpr std::size_t min_bytes = 12;
        std::vector<Vec3f> vertices(read_count(min_bytes));
        std::vector<Vec3f> normals(vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            vertices[i] = convert<float>(tokens_.vector("a vertex of a patch"));
            normals[i] = convert<float>(tokens_.vector("a normal of a patch"));
            if (normals[i] == Vec3f{0, 0, 0}) throw Error(tokens_.place(), "a normal that is not zero", "0 0 0");
        }
        if (spans_no_area(vertices)) throw Error(place, "a patch with an area", "vertices on one line");
        add(make_patch(std::move(vertices), std::move(normals)), 1, "patch", place);
    }

    std::size_t read_count(std::size_t min_bytes) {
        const int count = tokens_.whole(3, std::numeric_limits<int>::max(), "the number of vertices");
        tokens_.expect_room_for(count, min_bytes, "vertices");
        return static_cast<std::size_t>(count);
    }

    // A negative `sign` means that the shape is seen from inside.
    void add(Shape shape, double sign, const std::string& kind, const Place& place) {
        if (scene_.materials.empty()) throw Error(place, "a fill (f) before the first object", kind);
        if (scene_.objects.size() == max_objects)
            throw Error(place, fmt::format("at most {} objects", max_objects), "more");
        check_shape(shape, place);
        const auto material = scene_.materials.size() - 1;
        const bool transmits = scene_.materials.back().kt > 0;
        const auto visible = sign < 0 ? Sides::back : Sides::front;
        scene_.objects.push_back({.shape = std::move(shape),
                                  .placement = {},
                                  .front = material,
                                  .back = material,
                                  .sides = transmits ? Sides::both : visible,
                                  .path = fmt::format("{} {}", kind, counts_[kind]++)});
    }

    NffTokens tokens_;
    Scene scene_;
    std::optional<Place> view_;
    std::vector<std::size_t> lights_without_color_;
    std::map<std::string, int> counts_;
};

}  // namespace

Scene read_nff(std::string_view text, const std::string& file) { return Reader(text, file).read(); }

}  // namespace raylab

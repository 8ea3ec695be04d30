#include "raylab/experiment/ray_sphere/ray_sphere_workloads.h"

#include "raylab/sampling/sequence.h"

#include <cmath>
#include <functional>

namespace raylab {

namespace {

SphereWorkload workload(std::string name, std::string about, WorkloadSize draw, std::uint64_t kind,
                        const std::function<SphereQuery(RandomSequence&)>& make) {
    SphereWorkload result{std::move(name), std::move(about), {}, {}};
    result.queries.reserve(draw.count);
    for (std::size_t i = 0; i < draw.count; ++i) {
        RandomSequence random(draw.seed, i, kind);
        result.queries.push_back(make(random));
    }
    return result;
}

Sphere rounded(const Vec3d& center, double radius) { return {convert<float>(center), cast<float>(radius)}; }

Vec3d exactly(const Vec3f& v) { return convert<double>(v); }

// A ray from `distance` radii away that passes the center of a unit sphere at about `offset`.
SphereQuery passing(double distance, double offset, RandomSequence& random) {
    const Sphere sphere = rounded(random.in_cube(), 1);
    const Vec3d axis = random.unit_vector();
    const Vec3f origin = convert<float>(exactly(sphere.center) + axis * distance);
    // In the plane through the center the line's target must lie slightly farther out, because the line is slanted.
    const double in_plane = offset / std::sqrt(1 - offset * offset / (distance * distance));
    const Vec3d target = exactly(sphere.center) + random.unit_vector_across(axis) * in_plane;
    return {{origin, convert<float>(glm::normalize(target - exactly(origin)))}, sphere};
}

// Three integer vectors, perpendicular to each other and all of the integer length N: the columns of a rotation by the
// quaternion (a, b, c, d), times N = a^2 + b^2 + c^2 + d^2 (Euler, Rodrigues).
struct WholeFrame {
    Vec3f x, y;
    int length;
};

Vec3f whole(int x, int y, int z) { return {cast<float>(x), cast<float>(y), cast<float>(z)}; }

WholeFrame whole_frame(int largest, RandomSequence& random) {
    const int a = random.whole(-largest, largest);
    const int b = random.whole(-largest, largest);
    const int c = random.whole(-largest, largest);
    const int d = random.whole(1, largest);  // never zero, so the quaternion is not zero
    return {whole(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)),
            whole(2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)),
            a * a + b * b + c * c + d * d};
}

// The ray has the direction of one vector of the frame and touches the sphere at the tip of another, at t = steps /
// stride. Small: every product is below (14 N^2)^2 < 2^24. Large: in double a, b and c are still exact, and b^2 and a c
// are rounded alike.
SphereQuery tangent(Wholes wholes, RandomSequence& random) {
    const WholeFrame frame = whole_frame(wholes == Wholes::small ? 2 : 40, random);
    const Vec3f center = convert<float>(glm::round(9.0 * random.in_cube()));
    const float steps = cast<float>(random.whole(1, 2));
    const float stride = cast<float>((wholes == Wholes::small ? 1 : 7) * (2 * random.whole(1, 3) + 1));
    return {{center + frame.y - frame.x * steps, frame.x * stride}, {center, cast<float>(frame.length)}};
}

std::string power_of_ten(double value) {
    const int exponent = static_cast<int>(std::lround(std::log10(value)));
    return "1e" + std::to_string(exponent);
}

}  // namespace

SphereWorkload spheres_at(double distance, WorkloadSize draw) {
    const bool whole_power = std::abs(std::log10(distance) - std::round(std::log10(distance))) < 1e-9;
    const std::string times = whole_power ? power_of_ten(distance) : std::to_string(std::lround(distance));
    return workload("L/r = " + times, "a unit sphere from " + times + " radii away, passed within 1.2 radii", draw,
                    static_cast<std::uint64_t>(distance), [distance](RandomSequence& random) {
                        return passing(distance, 1.2 * std::sqrt(random.next()), random);
                    });
}

SphereWorkload silhouettes(WorkloadSize draw) {
    return workload("silhouette", "a unit sphere from 100 radii away, passed at 1 +- 1e-4 radii", draw, 1,
                    [](RandomSequence& random) { return passing(100, 1 + 1e-4 * random.between(-1, 1), random); });
}

SphereWorkload inside_starts(WorkloadSize draw) {
    return workload("inside", "rays from inside a sphere", draw, 3, [](RandomSequence& random) {
        const Sphere sphere = rounded(random.in_cube(), random.between(0.5, 2));
        // Uniform in the ball, because the volume within a distance grows as its cube.
        const double distance = 0.999 * double{sphere.radius} * std::cbrt(random.next());
        const Vec3d from_center = random.unit_vector() * distance;
        return SphereQuery{{convert<float>(exactly(sphere.center) + from_center), convert<float>(random.unit_vector())},
                           sphere};
    });
}

SphereWorkload surface_starts(WorkloadSize draw) {
    return workload("on the surface", "rays that leave a sphere from its surface", draw, 4, [](RandomSequence& random) {
        const Sphere sphere = rounded(random.in_cube(), random.between(0.5, 2));
        const Vec3d normal = random.unit_vector();
        Vec3d away = random.unit_vector();
        if (dot(away, normal) < 0) away = -away;
        return SphereQuery{
            {convert<float>(exactly(sphere.center) + normal * double{sphere.radius}), convert<float>(away)}, sphere};
    });
}

SphereWorkload tangents(Wholes wholes, WorkloadSize draw) {
    const std::string which = wholes == Wholes::small ? "small" : "large";
    return workload("tangent, " + which, "rays that touch a sphere exactly, in " + which + " whole numbers", draw, 5,
                    [wholes](RandomSequence& random) { return tangent(wholes, random); });
}

SphereWorkload near_tangents(WorkloadSize draw) {
    return workload("near tangent", "the small tangents, and the radius one float smaller: all miss", draw, 5,
                    [](RandomSequence& random) {
                        SphereQuery query = tangent(Wholes::small, random);
                        query.sphere.radius = std::nextafter(query.sphere.radius, 0.0f);
                        return query;
                    });
}

SphereWorkload sphere_floor(const Floor& floor, WorkloadSize draw) {
    const std::string name =
        "floor " + power_of_ten(floor.radius) + (floor.up == Up::tilted ? ", tilted" : ", along y");
    return workload(name, "an eye above a sphere of radius " + power_of_ten(floor.radius), draw, 2,
                    [floor](RandomSequence& random) {
                        const Vec3d up = floor.up == Up::tilted ? random.unit_vector() : Vec3d{0, 1, 0};
                        const double eye = floor.radius + floor.eye_height;  // distance from the center
                        const Sphere sphere = rounded(up * -eye, floor.radius);
                        // The center was rounded (to whole metres at 1e7); the eye's position makes up for it.
                        const Vec3d origin = up * (eye - glm::length(exactly(sphere.center)));
                        const double steepness = random.between(0.5, 1);
                        const Vec3d down = random.unit_vector_across(up) - up * steepness;
                        return SphereQuery{{convert<float>(origin), convert<float>(glm::normalize(down))}, sphere};
                    });
}

SphereWorkload generic_spheres(WorkloadSize draw) { return scaled_spheres("generic", 0, draw); }

SphereWorkload scaled_spheres(const std::string& name, int exponent, WorkloadSize draw) {
    const float scale = std::ldexp(1.0f, exponent);
    return workload(name,
                    "rays that pass a unit sphere within 1.2 radii, all lengths times 2^" + std::to_string(exponent),
                    draw, 6, [scale](RandomSequence& random) {
                        SphereQuery query = passing(4, 1.2 * std::sqrt(random.next()), random);
                        query.ray.origin *= scale;
                        query.ray.direction *= scale;
                        query.sphere.center *= scale;
                        query.sphere.radius *= scale;
                        return query;
                    });
}

std::vector<SphereWorkload> ray_sphere_workloads(WorkloadSize draw) {
    return {generic_spheres(draw),
            spheres_at(1e2, draw),
            spheres_at(1e3, draw),
            spheres_at(4096, draw),
            spheres_at(1e5, draw),
            spheres_at(1e7, draw),
            silhouettes(draw),
            tangents(Wholes::small, draw),
            tangents(Wholes::large, draw),
            near_tangents(draw),
            inside_starts(draw),
            surface_starts(draw),
            sphere_floor({.radius = 1e5}, draw),
            sphere_floor({.radius = 1e7}, draw),
            sphere_floor({.radius = 1e7, .up = Up::along_y}, draw),
            scaled_spheres("tiny", -50, draw),
            scaled_spheres("huge", 43, draw)};
}

}  // namespace raylab

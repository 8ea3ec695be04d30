#include "raylab/experiment/ray_quadric/ray_quadric_workloads.h"

#include "raylab/geometry/surface/gradient.h"
#include "raylab/sampling/sequence.h"

#include <array>
#include <cmath>
#include <functional>

namespace raylab {

namespace {

float length(double low, double high, RandomSequence& random) { return cast<float>(random.between(low, high)); }

Vec3d axis_vector(RandomSequence& random) {
    const double length = random.between(0.5, 2);
    return random.unit_vector() * length;
}

Quadric drawn(QuadricKind kind, RandomSequence& random) {
    const Vec3d start = random.in_cube();
    const Vec3f base = convert<float>(start);
    const Vec3f top = convert<float>(start + axis_vector(random));
    const Ends ends = random.next() < 0.5 ? Ends::open : Ends::capped;
    const float one = length(0.3, 1, random);
    const float other = length(0.3, 1, random);
    switch (kind) {
        case QuadricKind::ellipsoid:
            return Ellipsoid{base, {one, other, length(0.3, 1, random)}};
        case QuadricKind::cylinder:
            return Cylinder{base, top, one, ends};
        case QuadricKind::cone:
            return Cone{base, top, one, random.next() < 0.5 ? 0 : other, ends};
        case QuadricKind::paraboloid:
            return Paraboloid{base, top, one, ends};
        case QuadricKind::hyperboloid:
            return Hyperboloid{base, top, one / 2, one, ends};
        case QuadricKind::any:
            break;
    }
    return drawn(static_cast<QuadricKind>(random.whole(0, 4)), random);
}

// A point of an ellipsoid, or of a surface of revolution at height s.
Vec3d point_on(const EllipsoidOf<double>& ellipsoid, double, RandomSequence& random) {
    return ellipsoid.center + ellipsoid.radii * random.unit_vector();
}
Vec3d point_on(const Revolution<double>& surface, double s, RandomSequence& random) {
    return surface.base + surface.axis * s +
           random.unit_vector_across(surface.axis) * std::sqrt(surface.squared_radius(s));
}
Vec3d point_on(const SphereOf<double>& sphere, double, RandomSequence& random) {
    return sphere.center + random.unit_vector() * sphere.radius;
}
Vec3d point_on(const Quadric& quadric, double s, RandomSequence& random) {
    return std::visit([&](const auto& shape) { return point_on(in<double>(shape), s, random); }, quadric);
}

Ray ray_through(const Vec3d& target, const Vec3d& direction, double distance) {
    const Vec3f origin = convert<float>(target - direction * distance);
    return {origin, convert<float>(glm::normalize(target - convert<double>(origin)))};
}

// A workload of a hundred quadrics; every hundredth ray is for the same one.
QuadricWorkload workload(std::string name, std::string about, WorkloadSize draw, std::uint64_t number,
                         const std::function<Quadric(RandomSequence&)>& make,
                         const std::function<Ray(const Quadric&, RandomSequence&)>& aim) {
    constexpr std::size_t quadrics = 100;
    QuadricWorkload result{std::move(name), std::move(about), {}, {}};
    for (std::size_t i = 0; i < quadrics; ++i) {
        RandomSequence random(draw.seed, i, 2 * number);
        result.data.push_back(make(random));
    }
    for (std::size_t i = 0; i < draw.count; ++i) {
        RandomSequence random(draw.seed, i, 2 * number + 1);
        const std::size_t quadric = i % quadrics;
        result.queries.push_back({aim(result.data[quadric], random), quadric});
    }
    return result;
}

std::string name_of(QuadricKind kind) {
    constexpr std::array names = {"ellipsoid", "cylinder", "cone", "paraboloid", "hyperboloid", "any quadric"};
    return names[static_cast<std::size_t>(kind)];
}

}  // namespace

QuadricWorkload quadrics_at(double distance, QuadricKind kind, WorkloadSize draw) {
    const std::string from = "from " + std::to_string(std::lround(distance)) + " away";
    const std::string name = distance > 10 ? name_of(kind) + ", " + from : name_of(kind);
    return workload(
        name, "rays that pass close by " + from, draw, 10 + static_cast<std::uint64_t>(kind),
        [kind](RandomSequence& random) { return drawn(kind, random); },
        [distance](const Quadric& quadric, RandomSequence& random) {
            const Vec3d point = point_on(quadric, random.next(), random);
            const Vec3d aside = 0.3 * random.in_cube();
            return ray_through(point + aside, random.unit_vector(), distance);
        });
}

QuadricWorkload rims(WorkloadSize draw) {
    return workload(
        "rims", "rays aimed at the circle in which side and cap meet", draw, 20,
        [](RandomSequence& random) -> Quadric {
            const Vec3d base = random.in_cube();
            const Vec3d top = base + axis_vector(random);
            const float radius = length(0.3, 1, random);
            return Cylinder{convert<float>(base), convert<float>(top), radius, Ends::capped};
        },
        [](const Quadric& quadric, RandomSequence& random) {
            const Vec3d point = point_on(quadric, random.whole(0, 1), random);
            return ray_through(point, random.unit_vector(), 4);
        });
}

QuadricWorkload apexes(WorkloadSize draw) {
    return workload(
        "apexes", "rays aimed at the apex of a cone", draw, 21,
        [](RandomSequence& random) -> Quadric {
            const Vec3d base = random.in_cube();
            const Vec3d top = base + axis_vector(random);
            return Cone{convert<float>(base), convert<float>(top), length(0.3, 1, random), 0};
        },
        [](const Quadric& quadric, RandomSequence& random) {
            const Vec3d apex = point_on(quadric, 1, random);
            return ray_through(apex, random.unit_vector(), 4);
        });
}

QuadricWorkload grazing_quadrics(WorkloadSize draw) {
    return workload(
        "grazing", "rays in the tangent plane of a point of the surface, up to 1e-5 off it", draw, 22,
        [](RandomSequence& random) { return drawn(QuadricKind::any, random); },
        [](const Quadric& quadric, RandomSequence& random) {
            const Vec3d point = point_on(quadric, random.next(), random);
            const Vec3d normal = gradient_normal<double>(quadric, point, Part::side);
            const double height = 1e-5 * random.between(-1, 1);
            const Vec3d target = point + normal * height;
            return ray_through(target, random.unit_vector_across(normal), 4);
        });
}

}  // namespace raylab

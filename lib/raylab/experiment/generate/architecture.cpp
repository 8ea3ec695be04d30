#include "raylab/experiment/generate/architecture.h"

#include "raylab/experiment/generate/mason.h"
#include "raylab/sampling/sequence.h"

#include <cassert>

namespace raylab {

namespace {

constexpr double bay = 4, storey = 6, aisle = 4, nave = 6, width = nave + 2 * aisle;

// A curtain's pleats: tall narrow strips to and fro.
void add_curtain(Mason& mason, const Vec3d& start, double length, double height) {
    constexpr int pleats = 48;
    for (int i = 0; i < pleats; ++i) {
        const double from = i % 2 == 0 ? 0.12 : -0.12;
        mason.quad(start + Vec3d{length * i / pleats, 0, from}, {length / pleats, 0, -2 * from}, {0, height, 0});
    }
}

void add_bay(Mason& mason, double x, double z, double foot, const std::vector<Angle>& round) {
    constexpr double springing = 3.6, radius = 1.7, thickness = 0.6;
    const Vec3d axis{x + (bay - 2 * radius) / 2, foot, z};
    mason.column({x, foot + 0.3, z}, 0.28, springing - 0.6, round);
    mason.box({x - 0.4, foot, z - 0.4}, {x + 0.4, foot + 0.3, z + 0.4});
    mason.box({x - 0.4, foot + springing - 0.3, z - 0.4}, {x + 0.4, foot + springing, z + 0.4});
    mason.arch(axis + Vec3d{0, springing, -thickness / 2}, radius, thickness, foot + storey, round);
    for (int i = 1; i < 14; ++i) {
        const double at = x + 0.4 + (bay - 0.8) * i / 14;
        mason.box({at - 0.05, foot + 0.1, z - 0.05}, {at + 0.05, foot + 1, z + 0.05});
    }
}

}  // namespace

Mesh arcade_hall(int levels) {
    assert(levels >= 0 && levels <= 10);
    const auto round = circle(5);
    const int bays = 1 << levels;
    const double length = bay * bays;
    Mason mason;
    for (const double z : {0.0, width}) mason.quad({0, 0, z}, {length, 0, 0}, {0, 2 * storey, 0});
    for (const double x : {0.0, length}) mason.quad({x, 0, 0}, {0, 0, width}, {0, 2 * storey, 0});
    mason.quad({0, 2 * storey, 0}, {length, 0, 0}, {0, 0, width});
    mason.quad({0, 0, 0}, {length, 0, 0}, {0, 0, width});
    for (const double z : {aisle, aisle + nave})
        for (const double foot : {0.0, storey}) {
            for (const double height : {1.0, storey - 0.5, storey - 0.2})  // rail and cornices
                mason.box({0, foot + height, z - 0.45}, {length, foot + height + 0.1, z + 0.45});
            for (int i = 0; i < bays; ++i) {
                add_bay(mason, bay * i, z, foot, round);
                if (i % 2 == 0) add_curtain(mason, {bay * i + 0.5, foot + 1.2, z}, bay - 1, 2.4);
            }
        }
    for (const double z : {0.0, aisle + nave}) mason.quad({0, storey, z}, {length, 0, 0}, {0, 0, aisle});  // galleries
    for (double z = 0.5; z < width; z += 1)                                                                // purlins
        mason.box({0, 2 * storey - 0.5, z - 0.08}, {length, 2 * storey - 0.3, z + 0.08});
    for (int i = 0; i < bays; ++i) {
        mason.box({bay * i - 0.15, 2 * storey - 0.8, 0}, {bay * i + 0.15, 2 * storey - 0.4, width});
        for (int tile = 0; tile < 8 * 28; ++tile)
            mason.quad({bay * i + 0.5 * (tile % 8) + 0.01, 0.02, 0.5 * (tile / 8) + 0.01}, {0.48, 0, 0}, {0, 0, 0.48});
    }
    return mason.taken();
}

namespace {

constexpr double block = 40, street = 14, plot = block + street, floor_height = 3.5;

// A storey: a cornice that stands out, and the windows of its four sides.
void add_storey(Mason& mason, const Vec3d& min, const Vec3d& max) {
    constexpr double out = 0.3;
    constexpr int windows = 6;
    mason.box({min.x - out, max.y - 0.4, min.z - out}, {max.x + out, max.y, max.z + out});
    const Vec3d size = max - min;
    for (int i = 0; i < windows; ++i) {
        const double at = (i + 0.2) / windows, wide = 0.6 / windows;
        for (const double z : {min.z - 0.05, max.z + 0.05})
            mason.quad({min.x + at * size.x, min.y + 1, z}, {wide * size.x, 0, 0}, {0, 1.8, 0});
        for (const double x : {min.x - 0.05, max.x + 0.05})
            mason.quad({x, min.y + 1, min.z + at * size.z}, {0, 0, wide * size.z}, {0, 1.8, 0});
    }
}

void add_building(Mason& mason, double x, double z, RandomSequence& random) {
    Vec3d min{x, 0, z}, max{x + block, 0, z + block};
    for (int setback = random.whole(1, 3); setback > 0; --setback) {
        const int storeys = random.whole(3, 16);
        max.y = min.y + floor_height * storeys;
        mason.box(min, max);
        for (int i = 0; i < storeys; ++i)
            add_storey(mason, {min.x, min.y + floor_height * i, min.z}, {max.x, min.y + floor_height * (i + 1), max.z});
        const double in = random.between(2, 5);
        min = {min.x + in, max.y, min.z + in};
        max = {max.x - in, max.y, max.z - in};
    }
    if (random.next() < 0.3) mason.box({x + 19.9, min.y, z + 19.9}, {x + 20.1, min.y + 30, z + 20.1});
}

}  // namespace

Mesh city(int levels) {
    assert(levels >= 0 && levels <= 8);
    const int blocks = 1 << levels;
    const double length = plot * blocks + street;
    RandomSequence random(1, 0);
    Mason mason;
    mason.quad({0, -0.2, 0}, {length, 0, 0}, {0, 0, length});
    for (int i = 0; i <= blocks; ++i) {
        mason.quad({plot * i, 0, 0}, {street, 0, 0}, {0, 0, length});
        mason.quad({0, -0.1, plot * i}, {length, 0, 0}, {0, 0, street});
        for (const double kerb : {0.0, street - 0.3}) {
            mason.box({plot * i + kerb, 0, 0}, {plot * i + kerb + 0.3, 0.15, length});
            mason.box({0, 0, plot * i + kerb}, {length, 0.15, plot * i + kerb + 0.3});
        }
    }
    for (int i = 0; i < blocks; ++i)
        for (int j = 0; j < blocks; ++j) add_building(mason, street + plot * i, street + plot * j, random);
    return mason.taken();
}

}  // namespace raylab

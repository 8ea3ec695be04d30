#include "catch.h"

#include "raylab/radiosity/form_factor/closed_forms.h"

#include <array>
#include <cmath>
#include <numbers>

using namespace raylab;

TEST_CASE("equal rectangles that face each other, of any size: C-11 as computed with 60 digits") {
    struct Truth {
        double x, y, factor;
    };
    constexpr std::array truths{Truth{1e-6, 1e-6, 3.1830988618357846e-13}, Truth{1e-6, 1e-2, 3.1829927649071942e-9},
                                Truth{1e-6, 1, 2.4999999999992424e-7},     Truth{1e-6, 1000, 4.9968169021979449e-7},
                                Truth{1e-4, 1e-4, 3.1830988406172478e-9},  Truth{1e-4, 10, 4.6827448137249704e-5},
                                Truth{1e-3, 1e-2, 3.1829917039289852e-6},  Truth{1e-3, 1000, 0.00049968156527303357},
                                Truth{1e-2, 1e-2, 3.1828866732829196e-5},  Truth{1e-2, 1.001, 0.0025015149554349241},
                                Truth{0.1, 1, 0.02492465292946171},        Truth{0.5, 10, 0.22080973618152849},
                                Truth{1, 1, 0.19982489569838738},          Truth{1, 1000, 0.41393419807935092},
                                Truth{1.001, 1.001, 0.20008759251335154},  Truth{1.001, 1000, 0.41422675463535261},
                                Truth{2, 10, 0.57337582707651301},         Truth{10, 10, 0.82699452239725658},
                                Truth{100, 1000, 0.98908569307758451},     Truth{1000, 1000, 0.99800563190757973}};
    for (const auto& [x, y, factor] : truths) {
        INFO(x << " x " << y);
        CHECK_THAT(parallel_rectangles(x, y), WithinRel(factor, 1e-13));
        CHECK_THAT(parallel_rectangles(y, x), WithinRel(factor, 1e-13));
    }
}

TEST_CASE("as printed, C-11 loses its digits: a ten-thousandth of them at 0.001, all at 0.0001") {
    const auto error = [](double x) {
        return std::abs(parallel_rectangles_textbook(x, x) / parallel_rectangles(x, x) - 1);
    };
    CHECK(error(1) < 1e-15);
    CHECK(error(0.1) > 1e-14);
    CHECK(error(0.1) < 1e-11);
    CHECK(error(1e-3) > 1e-6);
    CHECK(error(1e-4) > 0.5);
}

TEST_CASE("perpendicular rectangles with a common edge: C-14") {
    CHECK_THAT(perpendicular_rectangles(1, 1), WithinRel(0.20004377607540315, 1e-14));
    CHECK_THAT(perpendicular_rectangles(2, 1), WithinRel(0.23285260279536189, 1e-14));
    CHECK_THAT(perpendicular_rectangles(1, 2), WithinRel(0.11642630139768094, 1e-14));
    CHECK_THAT(perpendicular_rectangles(0.5, 1), WithinRel(0.14618667910571332, 1e-14));
    CHECK_THAT(perpendicular_rectangles(0.1, 0.1), WithinRel(0.28188780678790143, 1e-13));
    CHECK_THAT(parallel_rectangles(1, 1) + 4 * perpendicular_rectangles(1, 1), WithinAbs(1, 1e-15));  // a cube
}

TEST_CASE("coaxial disks: C-41, also where its printed form cancels") {
    CHECK_THAT(coaxial_disks(1, 1, 1), WithinRel(0.381966011250105, 1e-14));
    CHECK_THAT(coaxial_disks(1, 2, 3), WithinRel(0.291796067500631, 1e-14));
    CHECK_THAT(coaxial_disks(2, 1, 3), WithinRel(0.0729490168751577, 1e-14));
    CHECK_THAT(coaxial_disks(1e-9, 1, 2), WithinRel(element_to_disk(1, 2), 1e-15));  // a tiny sender
    CHECK_THAT(coaxial_disks(1, 1e-9, 2), WithinRel(1e-18 * element_to_disk(1, 2), 1e-15));
}

TEST_CASE("a sphere and a small patch beside a disk") {
    CHECK_THAT(sphere_to_disk(1, 1), WithinRel(0.146446609406726, 1e-14));
    CHECK_THAT(sphere_to_disk(1e-6, 1), WithinRel(2.5e-13, 1e-11));  // the disk's share of the sphere's surroundings
    CHECK_THAT(element_to_disk(1, 2), WithinRel(0.2, 1e-15));
}

TEST_CASE("a small patch and a sphere at twice its radius, above the horizon, across it and below") {
    constexpr double degree = std::numbers::pi / 180;
    CHECK_THAT(element_to_sphere(1, 2, 30 * degree), WithinRel(0.21650635094611, 1e-13));
    CHECK_THAT(element_to_sphere(1, 2, 80 * degree), WithinRel(0.0546958164455, 1e-11));
    CHECK_THAT(element_to_sphere(1, 2, 90 * degree), WithinRel(0.0288344428112, 1e-11));
    CHECK_THAT(element_to_sphere(1, 2, 100 * degree), WithinRel(0.0112837720288, 1e-10));
    CHECK_THAT(element_to_sphere(1, 2, 60 * degree), WithinRel(element_to_sphere(1, 2, 60.000001 * degree), 1e-7));
    CHECK(element_to_sphere(1, 2, 121 * degree) == 0);
}

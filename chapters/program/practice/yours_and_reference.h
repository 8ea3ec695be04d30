#pragma once

#include "exercise.h"
#include "workplace.h"

#include "raylab/image/image.h"

#include <string>

namespace raylab {

/// The exercise's scene, drawn with the student's function and with the reference.
struct BesideEachOther {
    Image image;
    std::string missing;  // lines that say why yours is not whole; empty: it is
};

BesideEachOther yours_and_reference(const grading::Exercise& exercise, const grading::Workplace& workplace);

}  // namespace raylab

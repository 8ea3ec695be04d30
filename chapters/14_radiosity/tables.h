#pragma once

#include <string>
#include <vector>

namespace raylab::cornell {

/// The form factor of two unit squares that face each other at several distances, by every method, with its relative
/// error.
std::vector<std::string> square_header();
std::vector<std::vector<std::string>> square_rows();

/// The radiosities of a cube whose ceiling emits 1, for several reflectances, by elimination; and the iterations that
/// other solvers take to a residual of 1e-10.
std::vector<std::string> cube_header();
std::vector<std::vector<std::string>> cube_rows();

}  // namespace raylab::cornell

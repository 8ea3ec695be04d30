#pragma once

#include <cstddef>
#include <string>

// Numbers for people, in one style wherever they are shown: tables, charts, pages, the terminal.

namespace raylab {

/// A number with three digits: "0", "0.0123", "12.3", "1 234", "5.6·10⁷".
std::string number_text(double value);

/// All digits of a number of things: "2 000 000".
std::string count_text(std::size_t count);

/// A share with two digits. Below a hundredth of a per cent it is counted in parts per million: "0", "0.4 ppm", "12
/// ppm", "0.034 %", "3.4 %", "81 %". Only all is "100 %": slightly less is "99.9 %".
std::string share_text(double share);

/// How many times as much: "1.05 ×", "6.1 ×", "40 ×".
std::string ratio_text(double ratio);

/// A duration: "12.3 ns", "4.56 µs", "1.2 s".
std::string duration_text(double nanoseconds);

/// "⁻¹²": a whole number as an exponent.
std::string superscript(int number);

}  // namespace raylab

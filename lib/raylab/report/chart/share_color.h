#pragma once

#include <string>

namespace raylab {

/// The colours of a cell of a heat table.
struct ShareColor {
    std::string back, text;  // "#fdebd3"
};

/// The colours of a share of wrong answers: one for none at all, and one for each decade from a millionth to all, the
/// darker the more. Text on it is black or white, whichever differs more.
ShareColor share_color(double share);

/// How much two colours differ in brightness, from 1 to 21; small text needs 4.5 (Web Content Accessibility Guidelines
/// 2.2, success criterion 1.4.3).
double contrast_ratio(const std::string& a, const std::string& b);

}  // namespace raylab

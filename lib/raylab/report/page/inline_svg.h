#pragma once

#include <string>

namespace raylab {

/// A drawing as an element of a page, so that its marks can be pointed at. The style sheet knows as --drawn how wide it
/// was drawn. `name` must differ from every other drawing's on the page; `description`
/// is read to those who cannot see it.
std::string inline_svg(std::string svg, const std::string& name, const std::string& description);

}  // namespace raylab

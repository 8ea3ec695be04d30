#pragma once

#include <string>
#include <vector>

namespace raylab::grading {

/// What stands behind each #include of the text, with include_next and import: `"name"`, `<name>`, or anything else.
std::vector<std::string> included_names(const std::string& text);

}  // namespace raylab::grading

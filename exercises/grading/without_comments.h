#pragma once

#include <string>

namespace raylab::grading {

/// The text as the preprocessor looks for directives in it: a line that ends in a backslash is joined with the next,
/// each comment is a blank, literals stay. Its time grows with the text's length and not with its square, whatever is
/// in it.
std::string without_comments(const std::string& text);

}  // namespace raylab::grading

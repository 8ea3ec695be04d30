#pragma once

#include <string>
#include <string_view>
#include <vector>

// Formulas, written as TeX in a lesson, as MathML in its page.

namespace raylab {

/// A formula as a <math> element, made by the program blahtexml: browsers lay out MathML themselves, so that a page
/// needs neither a script nor a network for it. Where the program is not installed, the TeX itself is shown. It throws
/// an Error that names the formula where blahtexml does not understand it.
enum class FormulaPlace { in_line, displayed };
std::string formula_html(std::string_view tex, FormulaPlace place);

/// A displayed formula with its number: "a = b \tag{3}" gets the anchor eq-3.
std::string equation_html(std::string_view tex);

/// Takes the formulas out of Markdown's inline text, where a backslash, an underscore or a star would be read as
/// Markdown: each is replaced by a mark that no text has. Code and fences are left as they are.
class InlineFormulas {
public:
    /// The text with marks instead of $formulas$.
    std::string take_from(std::string_view markdown);

    /// HTML with the formulas in place of their marks.
    std::string put_into(std::string_view html) const { return put(html, Form::html); }
    /// Whether the text begins with a formula's mark.
    static bool begins_with_formula(std::string_view text);
    /// Plain text, such as the alternative text of a picture, with the formulas' TeX.
    std::string put_tex_into(std::string_view text) const { return put(text, Form::tex); }

private:
    enum class Form { html, tex };
    std::string put(std::string_view text, Form form) const;

    std::vector<std::string> formulas_;
};

}  // namespace raylab

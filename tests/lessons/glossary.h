#pragma once

#include "lesson_form.h"

// The words and symbols of a book of lessons: each is defined before it is used.

namespace raylab::lessons {

/// A lesson and the name by which complaints call it.
struct NamedLesson {
    std::string name;
    LessonText text;
};

/// The terms, and the formulas, of a lesson's list "Words and symbols".
std::vector<std::string> listed_terms(const LessonText& lesson);
std::vector<std::string> listed_formulas(const LessonText& lesson);

/// The symbols of a formula: letters, Latin and Greek, without indices, functions and words.
std::vector<std::string> symbols(const std::string& formula);

/// Every term that is bold in a text is in its list, and every term of the list is bold in the text, once.
Complaints definition_complaints(const NamedLesson& lesson);

/// No term is used before it is defined: in an earlier lesson, or earlier in its own. Titles, the lists and the sources
/// do not count.
Complaints early_use_complaints(const std::vector<NamedLesson>& book);

/// Each symbol of the last lesson's formulas is in its list or in that of a lesson before it.
Complaints symbol_complaints(const std::vector<NamedLesson>& book);

}  // namespace raylab::lessons

#pragma once

#include "lesson_text.h"

#include <cstddef>

// What is wrong with a lesson's form: each complaint is a sentence, and none is good.

namespace raylab::lessons {

using Complaints = std::vector<std::string>;

/// The title is "NN Title: question", as the chapter's program has them.
Complaints title_complaints(const LessonText& lesson, const std::string& number, const std::string& title,
                            const std::string& question);

/// Sections of the core, then the parts that every lesson has, in their order.
Complaints part_complaints(const LessonText& lesson);

/// The words of the core: from the introduction to the first of the other parts, without code, tables and folded text.
std::size_t core_words(const LessonText& lesson);

/// Three questions in bold, each with a folded answer that begins with the answer proper in bold; three experiments; a
/// summary of three to six sentences.
Complaints question_complaints(const LessonText& lesson);
Complaints experiment_complaints(const LessonText& lesson);
Complaints summary_complaints(const LessonText& lesson);

/// A line that begins as a figure is a whole one: a caption and a file in pictures/.
Complaints figure_complaints(const LessonText& lesson);

/// Formulas are numbered from 1 in the order of the text.
Complaints numbering_complaints(const LessonText& lesson);

/// Files of figures, as the lesson names them.
std::vector<std::string> figure_files(const LessonText& lesson);

}  // namespace raylab::lessons

#pragma once

namespace raylab {

/// The lab book's style sheet: every page carries it, so that each stands alone, offline.
const char* lab_book_style();

}  // namespace raylab

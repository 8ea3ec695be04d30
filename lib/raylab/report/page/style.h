#pragma once

namespace raylab {

/// The lab book's style sheet. Every page contains it, so that each is complete without a network.
const char* lab_book_style();

}  // namespace raylab

#pragma once

namespace raylab {

/// The files of the folders style/ and script/, in the order of their names: every page contains them, so that each is
/// complete without a network. CMake puts them into the program.
const char* page_style();
const char* page_script();

}  // namespace raylab

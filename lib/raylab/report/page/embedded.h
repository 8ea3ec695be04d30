#pragma once

namespace raylab {

/// The files of the folders style/ and script/, in the order of their names: every page contains them, so that each is
/// complete without a network. CMake puts them into the program.
const char* page_style();
const char* page_script();

/// The same for a walk through a solved scene, of the folder report/radiosity/walk/.
const char* walk_style();
const char* walk_script();

}  // namespace raylab

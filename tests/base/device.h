#pragma once

#include "catch.h"

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <filesystem>
#include <fstream>

/// Creates a device node of the test's own, never the system's; false, with a message, where it can be neither created
/// nor opened.
inline bool made_device(const std::filesystem::path& path, dev_t device) {
    if (mknod(path.c_str(), S_IFCHR | 0666, device) == 0 && std::ofstream(path)) return true;
    WARN("no device can be made here");
    return false;
}

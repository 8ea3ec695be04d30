#pragma once

namespace raylab {

/// Opens /dev/null, for reading only, as each of the descriptors 0, 1 and 2 that is closed: then no file that is opened
/// later becomes one of them, and printing there fails instead of ending up in that file.
void open_missing_standard_streams();

}  // namespace raylab

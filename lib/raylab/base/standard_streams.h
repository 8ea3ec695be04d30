#pragma once

namespace raylab {

/// Opens /dev/null, for reading only, as each of the descriptors 0, 1 and 2 that is closed: then no file opened later
/// becomes one of them, and what is printed there is refused instead of ending up in that file.
void open_missing_standard_streams();

}  // namespace raylab

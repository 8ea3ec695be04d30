#include "raylab/image/picture_files/openimageio.h"

#include "raylab/base/error.h"

#include <dlfcn.h>

namespace raylab::openimageio {

const Functions& functions() {
    static const Functions& found = []() -> const Functions& {
        void* module =
            // Never closed: the module stays loaded until the program ends.
            dlopen(RAYLAB_OPENIMAGEIO, RTLD_NOW | RTLD_LOCAL);
        void* symbol = module ? dlsym(module, "raylab_openimageio") : nullptr;
        if (!symbol) throw Error({RAYLAB_OPENIMAGEIO}, "the module that reads and writes pictures", dlerror());
        return *static_cast<const Functions*>(symbol);
    }();
    return found;
}

}  // namespace raylab::openimageio

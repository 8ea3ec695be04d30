#include "raylab/image/files.h"

#pragma once

#include "raylab/accelerator/adversarial_scenes.h"

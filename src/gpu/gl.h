#pragma once

// OpenGL ES 3.0: everything of it that is WebGL 2 too, and nothing else, is used.
#include <GLES3/gl3.h>

// OpenGL's functions, straight from the library that offscreen.cpp links: no loader, and no libGL beside it, whose symbols would shadow
// them.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

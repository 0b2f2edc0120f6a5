#pragma once

/// The OpenGL functions IRSG calls itself, linked directly (libOpenGL, 3.3 and older entry points).
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>

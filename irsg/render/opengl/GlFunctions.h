#pragma once

/// The OpenGL functions IRSG calls itself, linked directly (libOpenGL, entry points of 4.5).
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>

#pragma once

#include <string>

#include <osg/Image>

#include "irsg/geometry/conversion/TextureImage.h"

namespace irsg {

/// A picture in memory as readTexture reads one from a file; `name` is used in messages.
TextureImage textureOf(const osg::Image& image, const std::string& name);

} // namespace irsg

#pragma once

#include <vector>

#include <osg/Image>
#include <osg/StateAttribute>
#include <osg/Texture2D>

#include "irsg/core/Bytes.h"

namespace irsg {

/// Textures of one state and places on them of one geometry are handed over up to so many.
constexpr unsigned int mostTextureUnits = 8;

/// Appends an attribute of a state, with the number of the picture where it is a texture (-1 for
/// none). False, and nothing appended, for a kind that is not handed over.
bool putAttribute(ByteSink& sink, const osg::StateAttribute& attribute, std::int32_t image);

/// The attribute again. Throws DamagedBytes for a kind or a picture that there is not.
osg::ref_ptr<osg::StateAttribute> getAttribute(ByteSource& source,
                                               const std::vector<osg::ref_ptr<osg::Image>>& images);

} // namespace irsg

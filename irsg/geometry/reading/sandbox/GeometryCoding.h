#pragma once

#include <string>

#include <osg/Geometry>

#include "irsg/core/Bytes.h"

namespace irsg {

/// Vertices, normals, colours, texture coordinates and primitives as bytes. Throws InputError,
/// naming `name`, for vertices of a type that is no position.
void putGeometry(ByteSink& sink, const osg::Geometry& geometry, const std::string& name);

/// The geometry again, with nothing that would be read beyond an end: normals, colours and texture
/// coordinates that do not fit are left out and counted in `misfits`. Throws InputError, naming
/// `name`, for an index beyond the vertices and for more indices than vertices can have, and
/// DamagedBytes for what is no geometry at all.
osg::ref_ptr<osg::Geometry> getGeometry(ByteSource& source, const std::string& name, int& misfits);

} // namespace irsg

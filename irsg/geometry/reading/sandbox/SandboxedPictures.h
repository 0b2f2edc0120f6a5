#pragma once

#include <filesystem>

#include <osg/Image>

#include "irsg/geometry/reading/sandbox/ReaderProcess.h"

namespace irsg {

/// A picture that a process of its own reads. Throws InputError as ReaderProcess does.
osg::ref_ptr<osg::Image> readPictureSandboxed(ReaderProcess& process,
                                              const std::filesystem::path& file);

} // namespace irsg

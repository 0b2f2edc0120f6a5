#pragma once

#include <string>

#include <osg/Material>
#include <osg/StateSet>

namespace irsg {

/// The name that a file gives the material of this state, which readers put on its osg::Material,
/// or on the state itself where a file names a material without describing it; "" where it names
/// none.
inline std::string materialNameOf(const osg::StateSet& state) {
    const auto* material =
        dynamic_cast<const osg::Material*>(state.getAttribute(osg::StateAttribute::MATERIAL));
    return material && !material->getName().empty() ? material->getName() : state.getName();
}

} // namespace irsg

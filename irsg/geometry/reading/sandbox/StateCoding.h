#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <osg/Image>
#include <osg/StateSet>

#include "irsg/core/Bytes.h"

namespace irsg {

/// A picture as bytes: its numbers as they are, one layer, without smaller copies.
void putImage(ByteSink& sink, const osg::Image& image);
/// Throws DamagedBytes where size, format and number of bytes do not agree.
osg::ref_ptr<osg::Image> getImage(ByteSource& source);

/// States of a graph as bytes, each with its attributes and pictures once: what a fixed pipeline
/// draws with (materials, textures in one plane, culling, offsets, blending). The rest, shaders
/// above all, is left out and counted.
class StateEncoder {
  public:
    /// The number of this state, -1 for none.
    std::int32_t number(const osg::StateSet* state);
    /// Once all numbers are asked for.
    void moveTo(ByteSink& sink);
    /// Kinds of attributes that were left out.
    const std::set<std::string>& leftOut() const { return leftOut_; }

  private:
    std::int32_t number(const osg::StateAttribute& attribute);
    void putAttributes(ByteSink& sink, const osg::StateSet::AttributeList& attributes);
    bool putValues(ByteSink& sink, const osg::StateAttribute& attribute);
    std::int32_t number(const osg::Image* image);

    std::map<const osg::StateSet*, std::int32_t> states_;
    std::map<const osg::StateAttribute*, std::int32_t> attributes_;
    std::map<const osg::Image*, std::int32_t> images_;
    ByteSink stateBytes_, attributeBytes_, imageBytes_;
    std::int32_t written_ = 0; ///< attributes in attributeBytes_
    std::set<std::string> leftOut_;
};

/// The states again, in the order of their numbers.
std::vector<osg::ref_ptr<osg::StateSet>> getStates(ByteSource& source);

} // namespace irsg

#include "irsg/geometry/reading/sandbox/JointCoding.h"

#include "irsg/geometry/reading/sandbox/NumberCoding.h"

namespace irsg {

namespace {

using osgSim::DOFTransform;

/// One of the three vectors of each degree of freedom, and how it is read and set.
struct Limit {
    const osg::Vec3& (DOFTransform::*get)() const;
    void (DOFTransform::*set)(const osg::Vec3&);
};

constexpr Limit limits[] = {
    {&DOFTransform::getMinHPR, &DOFTransform::setMinHPR},
    {&DOFTransform::getMaxHPR, &DOFTransform::setMaxHPR},
    {&DOFTransform::getIncrementHPR, &DOFTransform::setIncrementHPR},
    {&DOFTransform::getCurrentHPR, &DOFTransform::setCurrentHPR},
    {&DOFTransform::getMinTranslate, &DOFTransform::setMinTranslate},
    {&DOFTransform::getMaxTranslate, &DOFTransform::setMaxTranslate},
    {&DOFTransform::getIncrementTranslate, &DOFTransform::setIncrementTranslate},
    {&DOFTransform::getCurrentTranslate, &DOFTransform::setCurrentTranslate},
    {&DOFTransform::getMinScale, &DOFTransform::setMinScale},
    {&DOFTransform::getMaxScale, &DOFTransform::setMaxScale},
    {&DOFTransform::getIncrementScale, &DOFTransform::setIncrementScale},
    {&DOFTransform::getCurrentScale, &DOFTransform::setCurrentScale}};

} // namespace

void putJoint(ByteSink& sink, const DOFTransform& joint) {
    for (const Limit& limit : limits)
        putNumbers(sink, (joint.*limit.get)());
    for (const osg::Matrixd& matrix : {joint.getPutMatrix(), joint.getInversePutMatrix()})
        putNumbers(sink, matrix);
    sink.put(static_cast<std::uint64_t>(joint.getLimitationFlags()));
    sink.put(static_cast<std::int32_t>(joint.getHPRMultOrder()));
    sink.put(static_cast<std::uint8_t>(joint.getAnimationOn()));
    sink.put(static_cast<std::uint8_t>(joint.getReferenceFrame() != osg::Transform::RELATIVE_RF));
}

osg::ref_ptr<DOFTransform> getJoint(ByteSource& source) {
    osg::ref_ptr<DOFTransform> joint = new DOFTransform;
    for (const Limit& limit : limits)
        (*joint.*limit.set)(getNumbers<osg::Vec3>(source));
    joint->setPutMatrix(getNumbers<osg::Matrixd>(source));
    joint->setInversePutMatrix(getNumbers<osg::Matrixd>(source));
    joint->setLimitationFlags(source.get<std::uint64_t>());
    const auto order = source.get<std::int32_t>();
    if (order < DOFTransform::PRH || order > DOFTransform::RHP)
        throw DamagedBytes("a joint that turns in no order");
    joint->setHPRMultOrder(static_cast<DOFTransform::MultOrder>(order));
    joint->setAnimationOn(source.getFlag());
    if (source.getFlag())
        joint->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    return joint;
}

} // namespace irsg

#include "irsg/scene/model/apart/JointCoding.h"

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

osg::Matrixd matrixOf(ByteSource& source) {
    osg::Matrixd matrix;
    const std::string_view bytes = source.getBytes(16 * sizeof(double));
    std::memcpy(matrix.ptr(), bytes.data(), bytes.size());
    return matrix;
}

} // namespace

void putJoint(ByteSink& sink, const DOFTransform& joint) {
    for (const Limit& limit : limits)
        sink.putBytes((joint.*limit.get)().ptr(), 3 * sizeof(float));
    for (const osg::Matrixd& matrix : {joint.getPutMatrix(), joint.getInversePutMatrix()})
        sink.putBytes(matrix.ptr(), 16 * sizeof(double));
    sink.put(static_cast<std::uint64_t>(joint.getLimitationFlags()));
    sink.put(static_cast<std::int32_t>(joint.getHPRMultOrder()));
    sink.put(static_cast<std::uint8_t>(joint.getAnimationOn()));
    sink.put(static_cast<std::uint8_t>(joint.getReferenceFrame() != osg::Transform::RELATIVE_RF));
}

osg::ref_ptr<DOFTransform> getJoint(ByteSource& source) {
    osg::ref_ptr<DOFTransform> joint = new DOFTransform;
    for (const Limit& limit : limits) {
        osg::Vec3 vector;
        const std::string_view bytes = source.getBytes(3 * sizeof(float));
        std::memcpy(vector.ptr(), bytes.data(), bytes.size());
        (*joint.*limit.set)(vector);
    }
    joint->setPutMatrix(matrixOf(source));
    joint->setInversePutMatrix(matrixOf(source));
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

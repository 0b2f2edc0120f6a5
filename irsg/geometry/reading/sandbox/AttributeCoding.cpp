#include "irsg/geometry/reading/sandbox/AttributeCoding.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <osg/AlphaFunc>
#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/FrontFace>
#include <osg/LightModel>
#include <osg/LineWidth>
#include <osg/Material>
#include <osg/Point>
#include <osg/PolygonMode>
#include <osg/PolygonOffset>
#include <osg/ShadeModel>
#include <osg/TexEnv>
#include <osg/TexMat>

namespace irsg {

namespace {

using Attribute = osg::StateAttribute;

constexpr auto front = osg::Material::FRONT, back = osg::Material::BACK;

/// A record is its kind and these; each kind uses some of them.
struct Values {
    std::int32_t integers[9] = {};
    float numbers[48] = {};
};

void keep(float* at, const osg::Vec4& v) {
    std::copy_n(v.ptr(), 4, at);
}
osg::Vec4 vec4(const float* at) {
    return {at[0], at[1], at[2], at[3]};
}

/// A number as one of the values that OpenSceneGraph has names for.
template <typename Value>
Value oneOf(std::int32_t number, std::initializer_list<Value> values) {
    for (const Value value : values)
        if (number == static_cast<std::int32_t>(value))
            return value;
    throw DamagedBytes("a state in a mode that there is not");
}

osg::Texture::WrapMode wrapOf(std::int32_t number) {
    using T = osg::Texture;
    return oneOf(number, {T::CLAMP, T::CLAMP_TO_EDGE, T::CLAMP_TO_BORDER, T::REPEAT, T::MIRROR});
}

osg::Texture::FilterMode filterOf(std::int32_t number) {
    using T = osg::Texture;
    return oneOf(number, {T::LINEAR, T::LINEAR_MIPMAP_LINEAR, T::LINEAR_MIPMAP_NEAREST, T::NEAREST,
                          T::NEAREST_MIPMAP_LINEAR, T::NEAREST_MIPMAP_NEAREST});
}

/// Functions of depth and of alpha have the same names.
template <typename Kind, typename Function>
Function functionOf(std::int32_t number) {
    return oneOf<Function>(number, {Kind::NEVER, Kind::LESS, Kind::EQUAL, Kind::LEQUAL,
                                    Kind::GREATER, Kind::NOTEQUAL, Kind::GEQUAL, Kind::ALWAYS});
}

osg::PolygonMode::Mode polygonModeOf(std::int32_t number) {
    using P = osg::PolygonMode;
    return oneOf(number, {P::POINT, P::LINE, P::FILL});
}

bool valuesOf(const osg::Material& m, Values& v) {
    v.integers[0] = m.getColorMode();
    // Whether the two sides are set as one.
    v.integers[1] = m.getAmbientFrontAndBack();
    v.integers[2] = m.getDiffuseFrontAndBack();
    v.integers[3] = m.getSpecularFrontAndBack();
    v.integers[4] = m.getEmissionFrontAndBack();
    v.integers[5] = m.getShininessFrontAndBack();
    for (const auto face : {front, back}) {
        float* at = v.numbers + (face == front ? 0 : 17);
        keep(at, m.getAmbient(face));
        keep(at + 4, m.getDiffuse(face));
        keep(at + 8, m.getSpecular(face));
        keep(at + 12, m.getEmission(face));
        at[16] = m.getShininess(face);
    }
    return true;
}

osg::StateAttribute* materialOf(const Values& v) {
    using M = osg::Material;
    const auto mode = oneOf(v.integers[0], {M::AMBIENT, M::DIFFUSE, M::SPECULAR, M::EMISSION,
                                            M::AMBIENT_AND_DIFFUSE, M::OFF});
    auto* m = new osg::Material;
    m->setColorMode(mode);
    for (const auto face : {back, front}) {
        const float* at = v.numbers + (face == front ? 0 : 17);
        const auto sides = [&](std::size_t which) {
            return face == front && v.integers[which] != 0 ? osg::Material::FRONT_AND_BACK : face;
        };
        m->setAmbient(sides(1), vec4(at));
        m->setDiffuse(sides(2), vec4(at + 4));
        m->setSpecular(sides(3), vec4(at + 8));
        m->setEmission(sides(4), vec4(at + 12));
        m->setShininess(sides(5), at[16]);
    }
    return m;
}

bool valuesOf(const osg::Texture2D& t, std::int32_t image, Values& v) {
    v.integers[0] = image;
    v.integers[1] = static_cast<std::int32_t>(t.getWrap(osg::Texture::WRAP_S));
    v.integers[2] = static_cast<std::int32_t>(t.getWrap(osg::Texture::WRAP_T));
    v.integers[3] = static_cast<std::int32_t>(t.getFilter(osg::Texture::MIN_FILTER));
    v.integers[4] = static_cast<std::int32_t>(t.getFilter(osg::Texture::MAG_FILTER));
    v.integers[5] = t.getResizeNonPowerOfTwoHint();
    v.integers[6] = t.getUseHardwareMipMapGeneration();
    keep(v.numbers, osg::Vec4(t.getBorderColor()));
    v.numbers[4] = t.getMaxAnisotropy();
    return true;
}

osg::StateAttribute* textureOf(const Values& v,
                               const std::vector<osg::ref_ptr<osg::Image>>& images) {
    const auto across = wrapOf(v.integers[1]), along = wrapOf(v.integers[2]);
    const auto smaller = filterOf(v.integers[3]), larger = filterOf(v.integers[4]);
    auto* t = new osg::Texture2D;
    const std::int32_t image = v.integers[0];
    if (image >= 0) {
        if (static_cast<std::size_t>(image) >= images.size()) {
            const osg::ref_ptr<osg::Texture2D> unused = t;
            throw DamagedBytes("a texture of a picture that is not there");
        }
        t->setImage(images[static_cast<std::size_t>(image)]);
    }
    t->setWrap(osg::Texture::WRAP_S, across);
    t->setWrap(osg::Texture::WRAP_T, along);
    t->setFilter(osg::Texture::MIN_FILTER, smaller);
    t->setFilter(osg::Texture::MAG_FILTER, larger);
    t->setResizeNonPowerOfTwoHint(v.integers[5] != 0);
    t->setUseHardwareMipMapGeneration(v.integers[6] != 0);
    t->setBorderColor(osg::Vec4d(vec4(v.numbers)));
    t->setMaxAnisotropy(std::isfinite(v.numbers[4]) ? v.numbers[4] : 1.0f);
    return t;
}

template <typename Kind>
const Kind* as(const Attribute& attribute) {
    return dynamic_cast<const Kind*>(&attribute);
}

bool simpleValuesOf(const Attribute& attribute, Values& v) {
    auto& n = v.integers;
    auto& x = v.numbers;
    const auto integers = [&](auto... values) {
        std::size_t at = 0;
        ((n[at++] = static_cast<std::int32_t>(values)), ...);
        return true;
    };
    if (const auto* a = as<osg::CullFace>(attribute))
        return integers(a->getMode());
    if (const auto* a = as<osg::FrontFace>(attribute))
        return integers(a->getMode());
    if (const auto* a = as<osg::ShadeModel>(attribute))
        return integers(a->getMode());
    if (const auto* a = as<osg::PolygonMode>(attribute))
        return integers(a->getMode(osg::PolygonMode::FRONT), a->getMode(osg::PolygonMode::BACK));
    if (const auto* a = as<osg::BlendFunc>(attribute))
        return integers(a->getSource(), a->getDestination(), a->getSourceAlpha(),
                        a->getDestinationAlpha());
    if (const auto* a = as<osg::PolygonOffset>(attribute)) {
        x[0] = a->getFactor();
        x[1] = a->getUnits();
        return true;
    }
    if (const auto* a = as<osg::AlphaFunc>(attribute)) {
        x[0] = a->getReferenceValue();
        return integers(a->getFunction());
    }
    if (const auto* a = as<osg::Depth>(attribute)) {
        x[0] = static_cast<float>(a->getZNear());
        x[1] = static_cast<float>(a->getZFar());
        return integers(a->getFunction(), a->getWriteMask());
    }
    if (const auto* a = as<osg::LineWidth>(attribute)) {
        x[0] = a->getWidth();
        return true;
    }
    if (const auto* a = as<osg::Point>(attribute)) {
        x[0] = a->getSize();
        return true;
    }
    if (const auto* a = as<osg::LightModel>(attribute)) {
        keep(x, a->getAmbientIntensity());
        return integers(a->getColorControl(), a->getLocalViewer(), a->getTwoSided());
    }
    if (const auto* a = as<osg::TexEnv>(attribute)) {
        keep(x, a->getColor());
        return integers(a->getMode());
    }
    if (const auto* a = as<osg::TexMat>(attribute)) {
        std::copy_n(a->getMatrix().ptr(), 16, x);
        return true;
    }
    return false;
}

osg::StateAttribute* simpleOf(std::int32_t kind, const Values& v) {
    const auto& n = v.integers;
    const auto& x = v.numbers;
    switch (kind) {
    case Attribute::CULLFACE:
        return new osg::CullFace(oneOf(
            n[0], {osg::CullFace::FRONT, osg::CullFace::BACK, osg::CullFace::FRONT_AND_BACK}));
    case Attribute::FRONTFACE:
        return new osg::FrontFace(
            oneOf(n[0], {osg::FrontFace::CLOCKWISE, osg::FrontFace::COUNTER_CLOCKWISE}));
    case Attribute::SHADEMODEL:
        return new osg::ShadeModel(oneOf(n[0], {osg::ShadeModel::FLAT, osg::ShadeModel::SMOOTH}));
    case Attribute::POLYGONMODE: {
        const auto before = polygonModeOf(n[0]), behind = polygonModeOf(n[1]);
        auto* a = new osg::PolygonMode;
        a->setMode(osg::PolygonMode::FRONT, before);
        a->setMode(osg::PolygonMode::BACK, behind);
        return a;
    }
    case Attribute::BLENDFUNC:
        return new osg::BlendFunc(static_cast<GLenum>(n[0]), static_cast<GLenum>(n[1]),
                                  static_cast<GLenum>(n[2]), static_cast<GLenum>(n[3]));
    case Attribute::POLYGONOFFSET:
        return new osg::PolygonOffset(x[0], x[1]);
    case Attribute::ALPHAFUNC:
        return new osg::AlphaFunc(
            functionOf<osg::AlphaFunc, osg::AlphaFunc::ComparisonFunction>(n[0]), x[0]);
    case Attribute::DEPTH:
        return new osg::Depth(functionOf<osg::Depth, osg::Depth::Function>(n[0]),
                              static_cast<double>(x[0]), static_cast<double>(x[1]), n[1] != 0);
    case Attribute::LINEWIDTH:
        return new osg::LineWidth(std::isfinite(x[0]) && x[0] > 0.0f ? x[0] : 1.0f);
    case Attribute::POINT:
        return new osg::Point(std::isfinite(x[0]) && x[0] >= 0.0f ? x[0] : 1.0f);
    case Attribute::LIGHTMODEL: {
        const auto control =
            oneOf(n[0], {osg::LightModel::SEPARATE_SPECULAR_COLOR, osg::LightModel::SINGLE_COLOR});
        auto* a = new osg::LightModel;
        a->setAmbientIntensity(vec4(x));
        a->setColorControl(control);
        a->setLocalViewer(n[1] != 0);
        a->setTwoSided(n[2] != 0);
        return a;
    }
    case Attribute::TEXENV:
        return new osg::TexEnv(
            oneOf(n[0], {osg::TexEnv::DECAL, osg::TexEnv::MODULATE, osg::TexEnv::BLEND,
                         osg::TexEnv::REPLACE, osg::TexEnv::ADD}));
    case Attribute::TEXMAT:
        return new osg::TexMat(osg::Matrix(x));
    default:
        throw DamagedBytes("a state of a kind that is not handed over");
    }
}

} // namespace

bool putAttribute(ByteSink& sink, const osg::StateAttribute& attribute, std::int32_t image) {
    Values values;
    const auto* material = as<osg::Material>(attribute);
    const auto* texture = as<osg::Texture2D>(attribute);
    const bool known = material  ? valuesOf(*material, values)
                       : texture ? valuesOf(*texture, image, values)
                                 : simpleValuesOf(attribute, values);
    if (known) {
        sink.put(static_cast<std::int32_t>(attribute.getType()));
        sink.put(values);
        sink.putText(attribute.getName());
    }
    return known;
}

osg::ref_ptr<osg::StateAttribute>
getAttribute(ByteSource& source, const std::vector<osg::ref_ptr<osg::Image>>& images) {
    const auto kind = source.get<std::int32_t>();
    const auto values = source.get<Values>();
    const std::string name = source.getText();
    osg::ref_ptr<osg::StateAttribute> attribute = kind == Attribute::MATERIAL ? materialOf(values)
                                                  : kind == Attribute::TEXTURE
                                                      ? textureOf(values, images)
                                                      : simpleOf(kind, values);
    if (auto* environment = dynamic_cast<osg::TexEnv*>(attribute.get()))
        environment->setColor(vec4(values.numbers));
    attribute->setName(name);
    return attribute;
}

} // namespace irsg

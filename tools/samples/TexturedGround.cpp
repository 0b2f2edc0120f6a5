#include "tools/samples/TexturedGround.h"

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/Image>
#include <osg/Texture2D>
#include <osgDB/WriteFile>

#include "irsg/core/Errors.h"

namespace smat {

namespace {

osg::ref_ptr<osg::Geode> geodeOf(const GroundSheet& sheet) {
    const int cells = sheet.cells;
    const osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
    const osg::ref_ptr<osg::Vec2Array> places = new osg::Vec2Array(osg::Array::BIND_PER_VERTEX);
    const osg::ref_ptr<osg::DrawElementsUShort> triangles =
        new osg::DrawElementsUShort(GL_TRIANGLES);
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const GroundCorner one = sheet.corner(i, j);
            vertices->push_back(one.place_m);
            places->push_back(one.inPicture);
        }
    const auto vertex = [&](int i, int j) {
        return static_cast<unsigned short>(j * (cells + 1) + i);
    };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            if (sheet.isThere && !sheet.isThere(i, j))
                continue;
            for (const unsigned short index :
                 {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j),
                  vertex(i + 1, j + 1), vertex(i, j + 1)})
                triangles->push_back(index);
        }

    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->setTexCoordArray(0, places);
    geometry->addPrimitiveSet(triangles);
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setFileName(sheet.picture);
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, sheet.wrap);
    texture->setWrap(osg::Texture::WRAP_T, sheet.wrap);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    geode->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    return geode;
}

} // namespace

void writeTexturedGround(const std::filesystem::path& file, std::span<const GroundSheet> sheets) {
    osg::ref_ptr<osg::Node> ground;
    if (sheets.size() == 1) {
        ground = geodeOf(sheets.front());
    } else {
        const osg::ref_ptr<osg::Group> group = new osg::Group;
        for (const GroundSheet& sheet : sheets)
            group->addChild(geodeOf(sheet));
        ground = group;
    }
    const osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("WriteImageHint=UseExternal Compressor=zlib");
    if (!osgDB::writeNodeFile(*ground, file.string(), options))
        throw irsg::InputError({file.string(), "", "cannot be written",
                                "a folder that can be written and the plug-in of .osgb"});
}

} // namespace smat

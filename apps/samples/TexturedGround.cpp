#include "apps/samples/TexturedGround.h"

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Image>
#include <osg/Texture2D>
#include <osgDB/WriteFile>

#include "irsg/radiometry/Errors.h"

namespace smat {

void writeTexturedGround(const std::filesystem::path& file, const std::string& picture,
                         osg::Texture::WrapMode wrap, int cells,
                         const std::function<GroundCorner(int i, int j)>& corner) {
    const osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
    const osg::ref_ptr<osg::Vec2Array> places = new osg::Vec2Array(osg::Array::BIND_PER_VERTEX);
    const osg::ref_ptr<osg::DrawElementsUShort> triangles =
        new osg::DrawElementsUShort(GL_TRIANGLES);
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const GroundCorner one = corner(i, j);
            vertices->push_back(one.place_m);
            places->push_back(one.inPicture);
        }
    const auto vertex = [&](int i, int j) {
        return static_cast<unsigned short>(j * (cells + 1) + i);
    };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i)
            for (const unsigned short index :
                 {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j),
                  vertex(i + 1, j + 1), vertex(i, j + 1)})
                triangles->push_back(index);

    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->setTexCoordArray(0, places);
    geometry->addPrimitiveSet(triangles);
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setFileName(picture);
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    geode->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    const osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("WriteImageHint=UseExternal Compressor=zlib");
    if (!osgDB::writeNodeFile(*geode, file.string(), options))
        throw irsg::InputError({file.string(), "", "cannot be written",
                                "a folder that can be written and the plug-in of .osgb"});
}

} // namespace smat

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <osg/StateSet>

#include "irsg/geometry/reading/text/ObjReader.h"

namespace irsg {

/// Materials of a Wavefront object by their names, as states for a visible view.
class ObjMaterials {
  public:
    /// `folder` is where the object lies: libraries and pictures are looked for there.
    ObjMaterials(std::filesystem::path folder, PictureReading picture);

    /// Reads a library. What cannot be read becomes a remark: faces have a place without it, too.
    void read(const std::string& name, std::vector<std::string>& remarks);
    /// The state of a material: nothing but the name for one that no library describes, none where
    /// there is no name.
    osg::ref_ptr<osg::StateSet> state(const std::string& name);
    /// The libraries that are there, readable or not.
    const std::vector<std::filesystem::path>& libraries() const { return libraries_; }

  private:
    struct Material {
        double ambient[3] = {0.2, 0.2, 0.2}, diffuse[3] = {0.8, 0.8, 0.8};
        double specular[3] = {0, 0, 0}, emission[3] = {0, 0, 0};
        double shininess = 0.0, alpha = 1.0;
        std::string picture;
    };
    void readText(const std::string& text, const std::string& file,
                  std::vector<std::string>& remarks);
    osg::ref_ptr<osg::StateSet> makeState(const std::string& name, const Material& material,
                                          std::vector<std::string>& remarks);
    osg::ref_ptr<osg::Image> image(const std::string& name, std::vector<std::string>& remarks);

    std::filesystem::path folder_;
    PictureReading picture_;
    std::map<std::string, osg::ref_ptr<osg::StateSet>> states_;
    std::map<std::string, osg::ref_ptr<osg::Image>> images_;
    std::vector<std::filesystem::path> libraries_;
};

} // namespace irsg

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <assimp/scene.h>
#include <osg/Image>
#include <osg/StateSet>

namespace irsg {

/// The materials of a scene of Assimp as states: name, colours, the picture of the base colour with
/// its alpha, blending, and culling where the format has a word for it.
class AssimpStates {
  public:
    /// The scene must outlive the object. `cullsBacks`: faces have one side unless their material
    /// says otherwise, as in glTF.
    AssimpStates(const aiScene& scene, std::filesystem::path file, bool cullsBacks)
        : scene_(scene), file_(std::move(file)), cullsBacks_(cullsBacks) {}

    osg::ref_ptr<osg::StateSet> state(unsigned int material);
    /// Which texture coordinates the picture of a material goes by.
    unsigned int placesOf(unsigned int material) const;
    const std::vector<std::string>& remarks() const { return remarks_; }

  private:
    osg::ref_ptr<osg::StateSet> make(const aiMaterial& material);
    void paint(osg::StateSet& state, const aiMaterial& material);
    osg::ref_ptr<osg::Image> image(const std::string& name);
    osg::ref_ptr<osg::Image> embedded(const aiTexture& texture, const std::string& name);
    osg::ref_ptr<osg::Image> beside(const std::string& name);

    const aiScene& scene_;
    std::filesystem::path file_;
    bool cullsBacks_;
    std::map<unsigned int, osg::ref_ptr<osg::StateSet>> states_;
    std::map<std::string, osg::ref_ptr<osg::Image>> images_;
    std::vector<std::string> remarks_;
};

} // namespace irsg

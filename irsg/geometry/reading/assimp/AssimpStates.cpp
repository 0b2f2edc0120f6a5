#include "irsg/geometry/reading/assimp/AssimpStates.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <osg/AlphaFunc>
#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Material>
#include <osg/Texture2D>
#include <osgDB/Registry>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/WrittenPath.h"
#include "irsg/geometry/reading/GuardedReading.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/GltfFile.h"
#include "irsg/geometry/reading/sandbox/PluginReading.h"
#include "irsg/geometry/reading/sandbox/ReadingLimits.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;
constexpr auto on = osg::StateAttribute::ON, off = osg::StateAttribute::OFF;
constexpr auto bothSides = osg::Material::FRONT_AND_BACK;

osg::Vec4 vec4(const aiColor4D& colour) {
    return {colour.r, colour.g, colour.b, colour.a};
}

osg::Texture::WrapMode wrapOf(aiTextureMapMode mode) {
    return mode == aiTextureMapMode_Clamp    ? osg::Texture::CLAMP_TO_EDGE
           : mode == aiTextureMapMode_Mirror ? osg::Texture::MIRROR
                                             : osg::Texture::REPEAT;
}

/// The picture of the base colour, which older materials call diffuse.
struct Picture {
    aiString name;
    unsigned int places = 0;
    aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap,
                                 aiTextureMapMode_Wrap};
    bool moved = false;
};

bool findPicture(const aiMaterial& material, Picture& picture) {
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
        if (material.GetTextureCount(type) == 0)
            continue;
        // What is not stated stays as it is.
        if (material.GetTexture(type, 0, &picture.name, nullptr, &picture.places, nullptr, nullptr,
                                picture.modes) != aiReturn_SUCCESS)
            continue;
        aiUVTransform transform;
        picture.moved =
            material.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == aiReturn_SUCCESS &&
            (transform.mTranslation != aiVector2D(0, 0) || transform.mRotation != 0 ||
             transform.mScaling != aiVector2D(1, 1));
        return true;
    }
    return false;
}

} // namespace

osg::ref_ptr<osg::StateSet> AssimpStates::state(unsigned int material) {
    auto& state = states_[material];
    if (!state && material < scene_.mNumMaterials)
        state = make(*scene_.mMaterials[material]);
    return state;
}

unsigned int AssimpStates::placesOf(unsigned int material) const {
    Picture picture;
    return material < scene_.mNumMaterials && findPicture(*scene_.mMaterials[material], picture)
               ? picture.places
               : 0;
}

osg::ref_ptr<osg::StateSet> AssimpStates::make(const aiMaterial& material) {
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setName(name.C_Str());

    aiColor4D base(0.8f, 0.8f, 0.8f, 1.0f), emission(0, 0, 0, 1), specular(0, 0, 0, 1);
    if (material.Get(AI_MATKEY_BASE_COLOR, base) != aiReturn_SUCCESS)
        material.Get(AI_MATKEY_COLOR_DIFFUSE, base);
    material.Get(AI_MATKEY_COLOR_EMISSIVE, emission);
    material.Get(AI_MATKEY_COLOR_SPECULAR, specular);
    float opacity = 1.0f, shininess = 0.0f;
    const bool opaque = material.Get(AI_MATKEY_OPACITY, opacity) != aiReturn_SUCCESS;
    material.Get(AI_MATKEY_SHININESS, shininess);

    // glTF says what alpha means; elsewhere it is how much covers what is behind.
    aiString mode;
    const bool stated = material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS;
    const std::string_view alphaMode = mode.C_Str();
    float alpha = stated ? base.a : opaque ? base.a : opacity;
    if (stated && alphaMode == "OPAQUE") {
        alpha = 1.0f;
        state->setMode(GL_ALPHA_TEST, off);
    }
    base.a = std::isfinite(alpha) ? std::clamp(alpha, 0.0f, 1.0f) : 1.0f;
    if (stated && alphaMode == "MASK") {
        float cut = 0.5f;
        material.Get(AI_MATKEY_GLTF_ALPHACUTOFF, cut);
        state->setAttributeAndModes(new osg::AlphaFunc(osg::AlphaFunc::GEQUAL, cut));
    } else if (alphaMode == "BLEND" || (!stated && base.a < 1.0f)) {
        state->setAttributeAndModes(new osg::BlendFunc);
        state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    }

    osg::ref_ptr<osg::Material> colours = new osg::Material;
    colours->setName(name.C_Str());
    colours->setDiffuse(bothSides, vec4(base));
    colours->setAmbient(bothSides, vec4(base));
    colours->setEmission(bothSides, vec4(emission));
    colours->setSpecular(bothSides, stated ? osg::Vec4(0, 0, 0, 1) : vec4(specular));
    colours->setShininess(bothSides,
                          std::isfinite(shininess) ? std::clamp(shininess, 0.0f, 128.0f) : 0.0f);
    state->setAttribute(colours);

    int bothSided = 0;
    if (cullsBacks_ &&
        (material.Get(AI_MATKEY_TWOSIDED, bothSided) != aiReturn_SUCCESS || bothSided == 0))
        state->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
    else
        state->setMode(GL_CULL_FACE, off);
    paint(*state, material);
    return state;
}

void AssimpStates::paint(osg::StateSet& state, const aiMaterial& material) {
    Picture picture;
    if (!findPicture(material, picture))
        return;
    if (picture.moved)
        appendUnique(remarks_,
                     "pictures that their material moves, turns or scales lie as they are");
    const auto read = image(picture.name.C_Str());
    if (!read)
        return;
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(read);
    texture->setWrap(osg::Texture::WRAP_S, wrapOf(picture.modes[0]));
    texture->setWrap(osg::Texture::WRAP_T, wrapOf(picture.modes[1]));
    state.setTextureAttributeAndModes(0, texture, on);
}

osg::ref_ptr<osg::Image> AssimpStates::image(const std::string& name) {
    const auto [place, added] = images_.try_emplace(name);
    if (!added)
        return place->second;
    try {
        const aiTexture* texture = scene_.GetEmbeddedTexture(name.c_str());
        place->second = texture ? embedded(*texture, name) : beside(name);
    } catch (const InputError& error) {
        appendUnique(remarks_, error.what());
    }
    return place->second;
}

osg::ref_ptr<osg::Image> AssimpStates::embedded(const aiTexture& texture, const std::string& name) {
    const std::string called = "the picture " + name + " in the file";
    if (texture.mHeight != 0 || !texture.pcData) {
        appendUnique(remarks_, called + " has no format and is left out");
        return nullptr;
    }
    const std::string_view bytes(reinterpret_cast<const char*>(texture.pcData), texture.mWidth);
    const std::string extension = bytes.starts_with("\x89PNG")        ? "png"
                                  : bytes.starts_with("\xFF\xD8\xFF") ? "jpg"
                                                                      : texture.achFormatHint;
    if (const auto refusal = refusalOf("picture." + extension, FileKind::picture)) {
        appendUnique(remarks_, called + " is not opened: " + *refusal);
        return nullptr;
    }
    allowMore(bytes.size());
    auto* reader = osgDB::Registry::instance()->getReaderWriterForExtension(extension);
    std::istringstream stream{std::string(bytes)};
    osg::ref_ptr<osg::Image> image;
    if (reader)
        image = reader->readImage(stream, GuardedReading::options()).takeImage();
    if (!image || !image->valid()) {
        appendUnique(remarks_, called + " cannot be read and is left out");
        return nullptr;
    }
    return image;
}

osg::ref_ptr<osg::Image> AssimpStates::beside(const std::string& name) {
    const std::string written = decodedUri(name);
    if (const auto refusal = refusalOf(written, FileKind::picture)) {
        appendUnique(remarks_, "refers to " + written + ", which is not opened: " + *refusal +
                                   ", expected " + expectationOf(FileKind::picture));
        return nullptr;
    }
    const WrittenPath found = findWrittenOrBeside(file_.parent_path(), written);
    std::error_code failure;
    if (!fs::is_regular_file(found.file, failure)) {
        appendUnique(remarks_, "refers to " + written + ", which is missing");
        return nullptr;
    }
    if (!found.remark.empty())
        appendUnique(remarks_, found.remark);
    if (const auto size = fs::file_size(found.file, failure); !failure)
        allowMore(size);
    const auto image = readPictureHere(found.file);
    image->setFileName(found.file.string());
    return image;
}

} // namespace irsg

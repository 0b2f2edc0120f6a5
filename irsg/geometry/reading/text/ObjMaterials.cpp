#include "irsg/geometry/reading/text/ObjMaterials.h"

#include <algorithm>
#include <utility>

#include <osg/BlendFunc>
#include <osg/Material>
#include <osg/Texture2D>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/WrittenPath.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/text/ModelText.h"
#include "irsg/geometry/reading/text/TextWords.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

/// The file that a name means; empty, with a remark, where there is none.
fs::path found(const fs::path& folder, const std::string& name, std::vector<std::string>& remarks) {
    const WrittenPath path = findWrittenOrBeside(folder, name);
    std::error_code ignored;
    if (!fs::is_regular_file(path.file, ignored)) {
        appendUnique(remarks, "refers to " + name + ", which is missing");
        return {};
    }
    if (!path.remark.empty())
        appendUnique(remarks, path.remark);
    return path.file;
}

/// Options of a picture stand before its name and have so many values at most.
std::string nameBehindOptions(const TextWords& words) {
    static constexpr std::pair<std::string_view, std::size_t> options[] = {
        {"-blendu", 1},  {"-blendv", 1}, {"-cc", 1},    {"-clamp", 1}, {"-texres", 1},
        {"-imfchan", 1}, {"-bm", 1},     {"-boost", 1}, {"-mm", 2},    {"-o", 3},
        {"-s", 3},       {"-t", 3},      {"-type", 1}};
    const auto& all = words.words();
    std::size_t at = 1;
    while (at < all.size()) {
        const auto* option =
            std::ranges::find(options, all[at], &std::pair<std::string_view, std::size_t>::first);
        if (option == std::end(options))
            break;
        ++at;
        // Of three numbers the last two may be missing.
        for (std::size_t i = 0; i < option->second && at < all.size(); ++i)
            if (i == 0 || parseNumber(all[at]))
                ++at;
    }
    if (at >= all.size())
        return "";
    return std::string(all[at].data(), all.back().data() + all.back().size());
}

osg::Vec4 colour(const double* rgb, double alpha) {
    return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]),
            static_cast<float>(alpha)};
}

} // namespace

ObjMaterials::ObjMaterials(fs::path folder, PictureReading picture)
    : folder_(std::move(folder)), picture_(std::move(picture)) {}

void ObjMaterials::read(const std::string& name, std::vector<std::string>& remarks) {
    if (const auto refusal = refusalOf(name, FileKind::materials)) {
        appendUnique(remarks, "refers to " + name + ", which is not opened: " + *refusal +
                                  ", expected " + expectationOf(FileKind::materials));
        return;
    }
    const fs::path file = found(folder_, name, remarks);
    if (file.empty())
        return;
    libraries_.push_back(file);
    try {
        readText(plainText(readFile(file), file.string()), file.string(), remarks);
    } catch (const InputError& error) {
        appendUnique(remarks, error.what());
    }
}

void ObjMaterials::readText(const std::string& text, const std::string& file,
                            std::vector<std::string>& remarks) {
    TextWords words(text, file);
    std::string name;
    Material material;
    bool any = false;
    std::vector<Diagnostic> diagnostics;
    const auto finish = [&] {
        if (any)
            states_[name] = makeState(name, material, remarks);
    };
    while (words.next()) {
        const std::string_view word = words.words()[0];
        double* const rgb = word == "Ka"   ? material.ambient
                            : word == "Kd" ? material.diffuse
                            : word == "Ks" ? material.specular
                            : word == "Ke" ? material.emission
                                           : nullptr;
        double number = 0.0;
        if (word == "newmtl") {
            finish();
            name = words.rest();
            material = {};
            any = true;
        } else if (rgb) {
            // A spectrum by file or in other terms keeps what was there.
            if (words.words().size() > 1 && parseNumber(words.words()[1]))
                words.numbers(1, std::min<std::size_t>(3, words.words().size() - 1), rgb,
                              diagnostics);
        } else if (word == "Ns" && words.numbers(1, 1, &number, diagnostics)) {
            material.shininess = std::clamp(number, 0.0, 128.0);
        } else if (word == "d" && words.words().size() == 2 &&
                   words.numbers(1, 1, &number, diagnostics)) {
            material.alpha = std::clamp(number, 0.0, 1.0);
        } else if (word == "Tr" && words.numbers(1, 1, &number, diagnostics)) {
            material.alpha = 1.0 - std::clamp(number, 0.0, 1.0);
        } else if (word == "map_Kd") {
            material.picture = nameBehindOptions(words);
        }
    }
    finish();
    if (!diagnostics.empty())
        appendUnique(remarks, diagnostics.front().message() + " (" +
                                  std::to_string(diagnostics.size()) +
                                  " lines like this are left out)");
}

osg::ref_ptr<osg::Image> ObjMaterials::image(const std::string& name,
                                             std::vector<std::string>& remarks) {
    const auto [place, added] = images_.try_emplace(name);
    if (!added)
        return place->second;
    if (const auto refusal = refusalOf(name, FileKind::picture)) {
        appendUnique(remarks, "refers to " + name + ", which is not opened: " + *refusal +
                                  ", expected " + expectationOf(FileKind::picture));
        return nullptr;
    }
    const fs::path file = found(folder_, name, remarks);
    if (file.empty())
        return nullptr;
    if (picture_) {
        try {
            place->second = picture_(file);
            place->second->setFileName(file.string());
        } catch (const InputError& error) {
            appendUnique(remarks, error.what());
        }
    }
    return place->second;
}

osg::ref_ptr<osg::StateSet> ObjMaterials::makeState(const std::string& name,
                                                    const Material& material,
                                                    std::vector<std::string>& remarks) {
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    osg::ref_ptr<osg::Material> colours = new osg::Material;
    state->setName(name);
    colours->setName(name);
    const auto faces = osg::Material::FRONT_AND_BACK;
    colours->setAmbient(faces, colour(material.ambient, material.alpha));
    colours->setDiffuse(faces, colour(material.diffuse, material.alpha));
    colours->setSpecular(faces, colour(material.specular, material.alpha));
    colours->setEmission(faces, colour(material.emission, material.alpha));
    colours->setShininess(faces, static_cast<float>(material.shininess));
    state->setAttribute(colours);
    if (!material.picture.empty())
        if (const auto picture = image(material.picture, remarks)) {
            osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(picture);
            texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
            texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
            state->setTextureAttributeAndModes(0, texture);
        }
    if (material.alpha < 1.0) {
        state->setAttributeAndModes(new osg::BlendFunc);
        state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    }
    return state;
}

osg::ref_ptr<osg::StateSet> ObjMaterials::state(const std::string& name) {
    auto& state = states_[name];
    if (!state && !name.empty()) {
        state = new osg::StateSet;
        state->setName(name);
    }
    return state;
}

} // namespace irsg

#include "irsg/scene/draw/GlFunctions.h"

#include "irsg/scene/draw/SurfacePass.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <osg/RenderInfo>
#include <osg/State>

#include "irsg/scene/draw/FloatTarget.h"
#include "irsg/scene/draw/FragmentList.h"
#include "irsg/scene/draw/LayerSort.h"
#include "irsg/scene/draw/ReversedDepth.h"
#include "irsg/scene/draw/ShaderProgram.h"
#include "irsg/scene/draw/Stopwatch.h"

namespace irsg {

namespace {

enum Product { radianceProduct = 0, factorProduct = 1, factorProductWithDistance = 2 };

/// The shader's variant for N.
int angleMode(float nAngleFactor) {
    return nAngleFactor == 0.0f ? 0 : nAngleFactor == 1.0f ? 1 : 2;
}

struct Raster {
    int width, height;
    osg::Matrixd clipFromEye;
};

Raster rasterOf(const SurfaceScene& scene, const SampleWindow& window) {
    Raster raster{window.width(), window.height(),
                  scene.camera->clipFromEye(window.drawnRectangle(), scene.depth)};
    if (window.shearRows) {
        // x_clip + a w - b y moves the sample's row r, counted from the top, by r / shearRows.
        const double perClip = 1.0 / (static_cast<double>(window.shearRows) * raster.width);
        osg::Matrixd shear;
        shear(1, 0) = -raster.height * perClip;
        shear(3, 0) = (raster.height - 1) * perClip;
        raster.clipFromEye = raster.clipFromEye * shear;
    }
    return raster;
}

/// True where nothing of a box comes within the sides of a raster: all its corners are beyond one
/// of them.
bool isOutside(const osg::BoundingBox& box, const osg::Matrixd& clipFromLocal) {
    if (!box.valid())
        return false;
    constexpr double rounding = 1e-6; // of what is drawn in float
    std::array<int, 4> beyond{};
    for (unsigned i = 0; i < 8; ++i) {
        const osg::Vec4d corner = osg::Vec4d(osg::Vec3d(box.corner(i)), 1.0) * clipFromLocal;
        const double w = corner.w() + rounding * std::abs(corner.w());
        beyond[0] += corner.x() > w;
        beyond[1] += corner.x() < -w;
        beyond[2] += corner.y() > w;
        beyond[3] += corner.y() < -w;
    }
    return std::ranges::find(beyond, 8) != beyond.end();
}

/// The items that a raster can show.
std::vector<SurfaceItem> itemsWithin(const SurfaceScene& scene, const Raster& raster) {
    std::vector<SurfaceItem> items;
    for (const SurfaceItem& item : scene.items)
        if (!isOutside(item.geometry->getBoundingBox(), item.eyeFromLocal * raster.clipFromEye))
            items.push_back(item);
    return items;
}

} // namespace

struct SurfacePass::Parts {
    using Variant = std::array<int, 5>; // product, sun, flux, angle, transparent
    std::map<Variant, ShaderProgram> programs;
    std::optional<ShaderProgram> occluder;
    FloatTarget radiance{{2}};
    FloatTarget factors{{4}};
    FloatTarget factorsWithDistance{{4, 1}};
    FragmentList list;
    std::uint32_t roomInList = 1u << 16; // grows to what the largest drawing needed
    std::vector<std::uint32_t> words;
    std::vector<float> plane0, plane1;
    double drawSeconds = 0.0, readSeconds = 0.0, sortSeconds = 0.0;

    const ShaderProgram& program(const Variant& variant) {
        const auto found = programs.find(variant);
        if (found != programs.end())
            return found->second;
        const auto& [product, sun, flux, angle, transparent] = variant;
        const auto define = [](const char* name, int value) {
            return "#define " + std::string(name) + " " + std::to_string(value) + "\n";
        };
        return programs
            .try_emplace(variant, std::vector<std::string>{"surface.vert.glsl"},
                         std::vector<std::string>{"surface.frag.glsl", "accurate.glsl"},
                         define("PRODUCT", product) + define("SUN_MODE", sun) +
                             define("FLUX_MODE", flux) + define("ANGLE_MODE", angle) +
                             define("TRANSPARENT", transparent))
            .first->second;
    }

    /// Leaves the depth of what hides surfaces, and no colour. What is nearer than the depth range
    /// is drawn at its near end.
    void drawOccluders(osg::RenderInfo& info, const SurfaceScene& scene, const Raster& raster) {
        if (scene.occluders.empty())
            return;
        if (!occluder)
            occluder.emplace(std::vector<std::string>{"terrain.vert.glsl"},
                             std::vector<std::string>{"occluder.frag.glsl"});
        glEnable(GL_DEPTH_CLAMP);
        glDisable(GL_CULL_FACE);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        occluder->use();
        for (const OccluderItem& item : scene.occluders) {
            occluder->set("clipFromModel", item.eyeFromLocal * raster.clipFromEye);
            item.geometry->draw(info);
        }
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDisable(GL_DEPTH_CLAMP);
        info.getState()->unbindVertexArrayObject();
    }

    /// Draws the items of one kind with the surface shader into the bound target.
    void drawItems(osg::RenderInfo& info, const SurfaceScene& scene,
                   const std::vector<SurfaceItem>& items, const Raster& raster, bool transparent,
                   Product product) {
        const ShaderProgram* current = nullptr;
        for (const SurfaceItem& item : items) {
            if (item.transparent != transparent)
                continue;
            const SurfaceRow& row = scene.rows[static_cast<std::size_t>(item.row)];
            const ShaderProgram& shader =
                program({product, scene.modes.sun, scene.modes.flux, angleMode(row.nAngleFactor),
                         transparent ? 1 : 0});
            if (&shader != current) {
                current = &shader;
                useProgram(shader, scene, raster);
            }
            shader.set("radiance", {row.thermal, row.up, row.down, row.sun});
            shader.set("surface",
                       {row.path, row.opacity, row.nAngleFactor, static_cast<float>(item.row + 1)});
            shader.set("eyeFromModel", item.eyeFromLocal);
            shader.set("clipFromModel", item.eyeFromLocal * raster.clipFromEye);
            osg::Matrixd inverse, transposed;
            inverse.invert(item.eyeFromLocal);
            transposed.transpose(inverse);
            shader.setNormalMatrix("eyeNormalFromModel", transposed);
            // Both walls of a transparent shell count, whatever its draw type.
            if (item.cullsBackFaces && !transparent)
                glEnable(GL_CULL_FACE);
            else
                glDisable(GL_CULL_FACE);
            offsetLayer(item.layer);
            item.geometry->draw(info);
        }
        offsetLayer(0);
        glDisable(GL_CULL_FACE);
        info.getState()->unbindVertexArrayObject();
    }

    /// Lifts a subface over the face in whose plane it lies: by as much as depth changes over a
    /// pixel, and by some steps of the depth buffer where it does not change. Depth grows towards
    /// the eye.
    static void offsetLayer(int layer) {
        constexpr float steps = 16.0f;
        if (layer == 0)
            return glDisable(GL_POLYGON_OFFSET_FILL);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(static_cast<float>(layer), steps * static_cast<float>(layer));
    }

    void useProgram(const ShaderProgram& shader, const SurfaceScene& scene, const Raster& raster) {
        shader.use();
        auto setDirection = [&](const char* name, const Vec3& v) {
            shader.set(name, static_cast<float>(v.x), static_cast<float>(v.y),
                       static_cast<float>(v.z));
        };
        setDirection("zenithEye", scene.modes.zenithEye);
        setDirection("sunEye", scene.modes.sunEye);
        shader.set("rasterWidth", raster.width);
        shader.set("capacity", static_cast<int>(roomInList));
    }

    /// Draws a window: the opaque surfaces into `target`, the transparent ones before them into the
    /// list. Returns the length of the list.
    std::uint32_t draw(osg::RenderInfo& info, const SurfaceScene& scene, const Raster& raster,
                       Product product, FloatTarget& target) {
        const std::vector<SurfaceItem> items = itemsWithin(scene, raster);
        const ReversedDepth reversed;
        target.reserve(raster.width, raster.height);
        target.bind(raster.width, raster.height);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, raster.width, raster.height);
        target.clear();
        glDisable(GL_SCISSOR_TEST);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDisable(GL_BLEND);
        if (!items.empty())
            drawOccluders(info, scene, raster);
        drawItems(info, scene, items, raster, false, product);

        std::uint32_t listed = 0;
        if (std::ranges::any_of(items, &SurfaceItem::transparent)) {
            // What goes to the list leaves the planes alone; a shader that writes none would fill
            // them with whatever it likes.
            glDepthMask(GL_FALSE);
            glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
            const int vectors = product == radianceProduct ? 1 : 2;
            for (;;) {
                list.begin(roomInList, vectors);
                drawItems(info, scene, items, raster, true, product);
                listed = list.count();
                if (listed <= roomInList)
                    break;
                roomInList = std::bit_ceil(listed);
            }
            glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
            glDepthMask(GL_TRUE);
        }
        glFinish();
        return listed;
    }
};

SurfacePass::SurfacePass() : parts_(std::make_unique<Parts>()) {}
SurfacePass::~SurfacePass() = default;

void SurfacePass::drawRadiance(osg::RenderInfo& info, const SurfaceScene& scene,
                               const SampleWindow& window, RadianceSamples& samples) {
    Parts& p = *parts_;
    const Raster raster = rasterOf(scene, window);
    std::uint32_t listed = 0;
    {
        Stopwatch watch(p.drawSeconds);
        listed = p.draw(info, scene, raster, radianceProduct, p.radiance);
    }
    samples.width = raster.width;
    samples.height = raster.height;
    {
        Stopwatch watch(p.readSeconds);
        p.radiance.read(0, raster.width, raster.height, samples.planes);
        p.list.read(listed, 1, p.words);
    }
    Stopwatch watch(p.sortSeconds);
    samples.layersLeftOver = layUnderTransparent(p.words, scene.maximumLayers, samples.planes);
}

void SurfacePass::drawFactors(osg::RenderInfo& info, const SurfaceScene& scene,
                              const SampleWindow& window, bool withDistance,
                              FactorSamples& samples) {
    Parts& p = *parts_;
    const Raster raster = rasterOf(scene, window);
    FloatTarget& target = withDistance ? p.factorsWithDistance : p.factors;
    std::uint32_t listed = 0;
    {
        Stopwatch watch(p.drawSeconds);
        listed = p.draw(info, scene, raster,
                        withDistance ? factorProductWithDistance : factorProduct, target);
    }
    samples.width = raster.width;
    samples.height = raster.height;
    {
        Stopwatch watch(p.readSeconds);
        target.read(0, raster.width, raster.height, p.plane0);
        if (withDistance)
            target.read(1, raster.width, raster.height, p.plane1);
        else
            p.plane1.clear();
        p.list.read(listed, 2, p.words);
    }
    Stopwatch watch(p.sortSeconds);
    gatherFactorLayers(p.words, p.plane0, p.plane1, scene.modes.flux != 0, scene.maximumLayers,
                       samples);
}

std::size_t SurfacePass::bytes() const {
    return parts_->radiance.bytes() + parts_->factors.bytes() +
           parts_->factorsWithDistance.bytes() + parts_->list.bytes();
}

double SurfacePass::takeDrawSeconds() {
    return std::exchange(parts_->drawSeconds, 0.0);
}
double SurfacePass::takeReadSeconds() {
    return std::exchange(parts_->readSeconds, 0.0);
}
double SurfacePass::takeSortSeconds() {
    return std::exchange(parts_->sortSeconds, 0.0);
}

} // namespace irsg

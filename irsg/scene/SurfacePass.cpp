#include "irsg/scene/GlFunctions.h"

#include "irsg/scene/SurfacePass.h"

#include <algorithm>
#include <utility>

#include <osg/RenderInfo>
#include <osg/State>

#include "irsg/scene/FloatTarget.h"
#include "irsg/scene/ShaderProgram.h"
#include "irsg/scene/Stopwatch.h"

namespace irsg {

namespace {

enum Product { radianceProduct = 0, factorProduct = 1 };
enum Peel { opaquePass = 0, firstLayer = 1, furtherLayer = 2 };
constexpr int opaqueDepthUnit = 0, previousDepthUnit = 1, layerUnit = 2;

/// Depth from 1 near to 0 far, for as long as it lives.
class ReversedDepth {
  public:
    ReversedDepth() { glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); }
    ~ReversedDepth() {
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        glDepthFunc(GL_LESS);
        glClearDepth(1.0);
    }
};

void bindTexture(int unit, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
}

} // namespace

struct SurfacePass::Parts {
    ShaderProgram surface{{"surface.vert.glsl"}, {"surface.frag.glsl", "accurate.glsl"}};
    ShaderProgram layer{{"fullscreen.vert.glsl"}, {"layer.frag.glsl"}};
    // Radiance needs one plane a target, factors two; the opaque pass has a target of its own,
    // layers are peeled into two in turn and gathered in the last.
    FloatTarget opaque[2] = {FloatTarget{1}, FloatTarget{2}};
    FloatTarget peeled[2][2] = {{FloatTarget{1}, FloatTarget{1}}, {FloatTarget{2}, FloatTarget{2}}};
    FloatTarget gathered{1};
    GLuint query = 0;
    double drawSeconds = 0.0;
    double readSeconds = 0.0;

    Parts() { glGenQueries(1, &query); }
    ~Parts() { glDeleteQueries(1, &query); }

    struct Raster {
        PixelWindow window;
        int samplesPerAxis;
        int width, height;
        osg::Matrixd clipFromEye;
    };

    static Raster raster(const SurfaceScene& scene, const PixelWindow& window, int samplesPerAxis) {
        return {window, samplesPerAxis, window.width * samplesPerAxis,
                window.height * samplesPerAxis, scene.camera->clipFromEye(window, scene.depth)};
    }

    /// Draws the items of one kind with the surface shader into the bound target.
    void drawItems(osg::RenderInfo& info, const SurfaceScene& scene, const Raster& raster,
                   bool transparent, Product product, Peel peel,
                   GLenum depthFunction = GL_GREATER) {
        surface.use();
        surface.set("product", static_cast<int>(product));
        surface.set("peel", static_cast<int>(peel));
        surface.set("opaqueDepth", opaqueDepthUnit);
        surface.set("previousDepth", previousDepthUnit);
        surface.set("sunMode", scene.modes.sun);
        surface.set("fluxMode", scene.modes.flux);
        auto setDirection = [&](const char* name, const Vec3& v) {
            surface.set(name, static_cast<float>(v.x), static_cast<float>(v.y),
                        static_cast<float>(v.z));
        };
        setDirection("zenithEye", scene.modes.zenithEye);
        setDirection("sunEye", scene.modes.sunEye);

        glEnable(GL_DEPTH_TEST);
        glDepthFunc(depthFunction);
        glDisable(GL_BLEND);
        for (const SurfaceItem& item : scene.items) {
            if (item.transparent != transparent)
                continue;
            const SurfaceRow& row = scene.rows[static_cast<std::size_t>(item.row)];
            surface.set("radiance", {row.thermal, row.up, row.down, row.sun});
            surface.set("surface", {row.path, row.opacity, row.nAngleFactor,
                                    static_cast<float>(item.row + 1)});
            surface.set("eyeFromModel", item.eyeFromLocal);
            surface.set("clipFromModel", item.eyeFromLocal * raster.clipFromEye);
            osg::Matrixd inverse;
            inverse.invert(item.eyeFromLocal);
            osg::Matrixd transposed;
            transposed.transpose(inverse);
            surface.setNormalMatrix("eyeNormalFromModel", transposed);
            // Both walls of a transparent shell count, whatever its draw type.
            if (item.cullsBackFaces && !transparent)
                glEnable(GL_CULL_FACE);
            else
                glDisable(GL_CULL_FACE);
            item.geometry->draw(info);
        }
        glDisable(GL_CULL_FACE);
        info.getState()->unbindVertexArrayObject();
    }

    void drawOpaque(osg::RenderInfo& info, const SurfaceScene& scene, const Raster& raster,
                    Product product, FloatTarget& target) {
        target.reserve(raster.width, raster.height);
        target.bind(raster.width, raster.height);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, raster.width, raster.height);
        target.clear();
        drawItems(info, scene, raster, false, product, opaquePass);
    }

    static bool touchesTransparent(const SurfaceScene& scene, const Raster& raster) {
        return std::ranges::any_of(scene.items, [&](const SurfaceItem& item) {
            return item.transparent && !item.window.intersectedWith(raster.window).empty();
        });
    }

    /// Restricts drawing to the samples that transparent surfaces can touch.
    static void scissorToTransparent(const SurfaceScene& scene, const Raster& raster) {
        PixelWindow touched;
        for (const SurfaceItem& item : scene.items)
            if (item.transparent)
                touched = touched.unitedWith(item.window);
        touched = touched.intersectedWith(raster.window);
        const int n = raster.samplesPerAxis;
        const int rowsBelow = raster.window.y + raster.window.height - touched.y - touched.height;
        glScissor((touched.x - raster.window.x) * n, rowsBelow * n, touched.width * n,
                  touched.height * n);
    }

    /// Peels one layer of the transparent surfaces into `target`; false when there is none.
    bool peelLayer(osg::RenderInfo& info, const SurfaceScene& scene, const Raster& raster,
                   Product product, bool first, const FloatTarget& opaqueTarget,
                   const FloatTarget& previous, FloatTarget& target) {
        target.reserve(raster.width, raster.height);
        target.bind(raster.width, raster.height);
        target.clear();
        bindTexture(opaqueDepthUnit, opaqueTarget.depthTexture());
        bindTexture(previousDepthUnit, previous.depthTexture());
        return fragmentsPassed([&] {
                   drawItems(info, scene, raster, true, product, first ? firstLayer : furtherLayer);
               }) > 0;
    }

    /// The number of samples in the layer just peeled: those fragments that lie at its depth.
    int samplesOfLayer(osg::RenderInfo& info, const SurfaceScene& scene, const Raster& raster,
                       Product product) {
        return static_cast<int>(fragmentsPassed(
            [&] { drawItems(info, scene, raster, true, product, furtherLayer, GL_EQUAL); }));
    }

    template <typename Drawing>
    GLuint fragmentsPassed(Drawing drawing) {
        glBeginQuery(GL_SAMPLES_PASSED, query);
        drawing();
        glEndQuery(GL_SAMPLES_PASSED);
        GLuint passed = 0;
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
        return passed;
    }

    /// gathered += (1 - alpha of gathered) * source, over the scissor.
    void layUnder(const Raster& raster, const FloatTarget& source) {
        gathered.bind(raster.width, raster.height);
        bindTexture(layerUnit, source.colourTexture(0));
        layer.use();
        layer.set("layer", layerUnit);
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
        glBegin(GL_TRIANGLES);
        glVertex2f(-1.0f, -1.0f);
        glVertex2f(3.0f, -1.0f);
        glVertex2f(-1.0f, 3.0f);
        glEnd();
        glDisable(GL_BLEND);
    }
};

SurfacePass::SurfacePass() : parts_(std::make_unique<Parts>()) {}
SurfacePass::~SurfacePass() = default;

int SurfacePass::drawRadiance(osg::RenderInfo& info, const SurfaceScene& scene,
                              const PixelWindow& window, int samplesPerAxis,
                              std::vector<float>& samples) {
    Parts& p = *parts_;
    const Parts::Raster raster = Parts::raster(scene, window, samplesPerAxis);
    FloatTarget& opaque = p.opaque[radianceProduct];
    const FloatTarget* result = &opaque;
    const ReversedDepth reversed;
    int leftOver = 0;
    {
        Stopwatch watch(p.drawSeconds);
        p.drawOpaque(info, scene, raster, radianceProduct, opaque);

        // Front to back, each layer under those before it; the opaque surfaces last.
        if (Parts::touchesTransparent(scene, raster)) {
            auto& peeled = p.peeled[radianceProduct];
            peeled[0].reserve(raster.width, raster.height);
            peeled[1].reserve(raster.width, raster.height);
            p.gathered.reserve(raster.width, raster.height);
            p.gathered.bind(raster.width, raster.height);
            p.gathered.clear();
            Parts::scissorToTransparent(scene, raster);
            for (int layer = 0; layer <= scene.maximumLayers; ++layer) {
                FloatTarget& target = peeled[layer % 2];
                if (!p.peelLayer(info, scene, raster, radianceProduct, layer == 0, opaque,
                                 peeled[(layer + 1) % 2], target))
                    break;
                if (layer == scene.maximumLayers)
                    leftOver = p.samplesOfLayer(info, scene, raster, radianceProduct);
                else
                    p.layUnder(raster, target);
            }
            glScissor(0, 0, raster.width, raster.height);
            p.layUnder(raster, opaque);
            result = &p.gathered;
        }
        glDisable(GL_SCISSOR_TEST);
        glFinish();
    }
    Stopwatch watch(p.readSeconds);
    result->read(0, raster.width, raster.height, samples);
    return leftOver;
}

int SurfacePass::drawFactors(osg::RenderInfo& info, const SurfaceScene& scene,
                             const PixelWindow& window, int samplesPerAxis,
                             const LayerSink& layerSink) {
    Parts& p = *parts_;
    const Parts::Raster raster = Parts::raster(scene, window, samplesPerAxis);
    FloatTarget& opaque = p.opaque[factorProduct];
    int leftOver = 0;
    std::vector<float> plane0, plane1;
    const ReversedDepth reversed;
    auto give = [&](const FloatTarget& target) {
        {
            Stopwatch watch(p.readSeconds);
            target.read(0, raster.width, raster.height, plane0);
            target.read(1, raster.width, raster.height, plane1);
        }
        layerSink(plane0, plane1);
    };

    {
        Stopwatch watch(p.drawSeconds);
        p.drawOpaque(info, scene, raster, factorProduct, opaque);
        glFinish();
    }
    if (Parts::touchesTransparent(scene, raster)) {
        auto& peeled = p.peeled[factorProduct];
        for (FloatTarget& target : peeled) {
            // Read whole below, drawn only inside the scissor: what lies outside must be empty.
            target.reserve(raster.width, raster.height);
            target.bind(raster.width, raster.height);
            target.clear();
        }
        Parts::scissorToTransparent(scene, raster);
        for (int layer = 0; layer <= scene.maximumLayers; ++layer) {
            FloatTarget& target = peeled[layer % 2];
            bool found = false;
            {
                Stopwatch watch(p.drawSeconds);
                found = p.peelLayer(info, scene, raster, factorProduct, layer == 0, opaque,
                                    peeled[(layer + 1) % 2], target);
            }
            if (!found)
                break;
            if (layer == scene.maximumLayers)
                leftOver = p.samplesOfLayer(info, scene, raster, factorProduct);
            else
                give(target);
        }
    }
    glDisable(GL_SCISSOR_TEST);
    give(opaque);
    return leftOver;
}

double SurfacePass::takeDrawSeconds() {
    return std::exchange(parts_->drawSeconds, 0.0);
}
double SurfacePass::takeReadSeconds() {
    return std::exchange(parts_->readSeconds, 0.0);
}

} // namespace irsg

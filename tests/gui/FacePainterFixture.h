#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include <QComboBox>
#include <QPushButton>
#include <QTest>

#include "gui/paint/FacePainter.h"
#include "irsg/geometry/model/Painting.h"
#include "irsg/signature/SignatureFile.h"
#include "tests/cli/Program.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui::test {

/// The window with cubes whose faces are painted by a person, for whom this test stands in.
class FacePainterTest : public WindowFixture {
  protected:
    /// Cubes of 2 m side by side along x, a triangle a face of the file; `high` is how high each
    /// is.
    static void writeCubes(const std::filesystem::path& file, const std::vector<double>& high) {
        std::ofstream out(file);
        for (std::size_t n = 0; n < high.size(); ++n) {
            for (int i = 0; i < 8; ++i) {
                out << "v " << 4.0 * static_cast<double>(n) + 2.0 * (i & 1) << ' '
                    << 2.0 * ((i >> 1) & 1) << ' ' << high[n] * ((i >> 2) & 1) << '\n';
            }
        }
        const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (std::size_t n = 0; n < high.size(); ++n) {
            out << "o cube" << n << "\nusemtl " << (n % 2 == 0 ? "Paint" : "Steel") << '\n';
            for (const auto& quad : quads) {
                for (const int start : {1, 2}) {
                    out << "f " << 8 * n + 1 + static_cast<std::size_t>(quad[0]) << ' '
                        << 8 * n + 1 + static_cast<std::size_t>(quad[start]) << ' '
                        << 8 * n + 1 + static_cast<std::size_t>(quad[start + 1]) << '\n';
                }
            }
        }
    }
    void openCubes(int count = 2) {
        file = folder / "cubes.obj";
        for (const char* beside :
             {"cubes.codes.json", "cubes.codes.json.recovery", "cubes.sigdb"}) {
            std::filesystem::remove(folder / beside);
        }
        writeCubes(file, std::vector<double>(static_cast<std::size_t>(count), 2.0));
        irsg::SignatureDatabase database;
        for (const auto& [index, kelvin] : {std::pair{0, 290.0}, {1, 600.0}}) {
            auto& entry = database.temperatures[index];
            entry.name = index == 0 ? "cold" : "hot";
            entry.terms.base_K = kelvin;
            auto& material = database.materials[index];
            material.name = index == 0 ? "grey" : "black";
            material.emissivity = irsg::Spectrum::constant(0.9);
        }
        irsg::createSignatureFile(database, folder / "cubes.sigdb");
        begin();
    }
    void begin() {
        ASSERT_TRUE(opens(file)) << told.join('\n').toStdString();
        workbench.set("camera.azimuth", "150");
        workbench.set("camera.elevation", "30");
        workbench.set("camera.range", "60");
        workbench.set("sensor.fov", "15");
        workbench.set("sensor.width", "320");
        workbench.set("sensor.height", "256");
        showPainter();
    }
    void showPainter() {
        if (!dock().isVisible()) {
            trigger("paintCodes");
        }
        QTest::qWait(50);
        ASSERT_TRUE(waitForPainter());
    }
    bool waitForPainter() {
        return waitUntil([this] { return painter().isReady(); }, 20.0);
    }
    PaintDock& dock() { return *window->findChild<PaintDock*>(); }
    FacePainter& painter() { return *window->findChild<FacePainter*>(); }
    template <typename Widget>
    Widget* field(const char* name) {
        return dock().findChild<Widget*>(name);
    }
    void press(const char* name) { field<QPushButton>(name)->click(); }
    /// Where the middle of a face is in the view.
    QPoint placeOf(unsigned int face) {
        SceneView* view = window->sceneView();
        const auto& shown = view->scene().models.front();
        const auto& model = view->scene().loaded.at(shown.key);
        const irsg::Vec3 at = model->fromFile().place(painter().mesh()->faces().at(face).point);
        return view->projection().toWindow(shown.pose.toWorld(at)).toPoint();
    }
    /// A face that is seen where its middle is.
    unsigned int seenFace(unsigned int from) {
        SceneView* view = window->sceneView();
        for (unsigned int f = from; f < painter().mesh()->faces().size(); ++f) {
            if (painter().mesh()->faces()[f].normal.z > 0.9 && view->rect().contains(placeOf(f))) {
                return f;
            }
        }
        ADD_FAILURE() << "no face is seen from " << from;
        return 0;
    }
    void clickFace(unsigned int face, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mouseClick(window->sceneView(), Qt::LeftButton, modifiers, placeOf(face));
    }
    void pickBy(PickBy by) {
        auto* box = field<QComboBox>("pickBy");
        box->setCurrentIndex(static_cast<int>(by));
        emit box->activated(static_cast<int>(by));
    }
    void give(const QString& temperature, const QString& material) {
        field<IndexBox>("paintTemperature")->setEditText(temperature);
        field<IndexBox>("paintMaterial")->setEditText(material);
    }
    void showCodes(CodesShown codes) {
        auto* box = field<QComboBox>("codesShown");
        box->setCurrentIndex(static_cast<int>(codes));
        emit box->activated(static_cast<int>(codes));
    }
    std::map<irsg::IrCodes, int> counts() {
        std::map<irsg::IrCodes, int> faces;
        const auto& scene = window->sceneView()->scene();
        for (const auto& [codes, use] : scene.loaded.at(scene.models.front().key)->codes()) {
            faces[codes] = use.faces;
        }
        return faces;
    }
    using Counts = std::map<irsg::IrCodes, int>;
    /// What smat-batch counts, from its table.
    Counts countsOfBatch() {
        const auto ran = smat::test::smatBatch({"model", "info", file.string()}, folder);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        Counts counts;
        std::istringstream lines(ran.out);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            irsg::IrCodes codes;
            int faces = 0;
            double area = 0.0;
            if (words >> codes.temperature >> codes.material >> faces >> area) {
                counts[codes] = faces;
            }
        }
        return counts;
    }
    bool saveProject() {
        chosen = QString::fromStdString((folder / "cubes.smat").string());
        trigger("saveProject");
        return told.isEmpty();
    }
    std::filesystem::path codesFile() const { return irsg::codesFileOf(file); }

    std::filesystem::path file;
};

} // namespace smat::gui::test

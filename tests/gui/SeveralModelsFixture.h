#pragma once

#include <QLineEdit>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "gui/project/SceneTreeDock.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui::test {

/// Scenes of several models, made in the window.
class SeveralModelsFixture : public WindowFixture {
  protected:
    static std::filesystem::path sampleFile(const char* name) {
        return std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name;
    }
    void addModel(const std::filesystem::path& file) {
        const std::size_t before = workbench.project().models.size();
        chosen = QString::fromStdString(file.string());
        trigger("addModel");
        ASSERT_TRUE(waitUntil([&] {
            return workbench.project().models.size() == before + 1 && !window->isLoadingModel();
        })) << told.join('\n').toStdString();
        ASSERT_TRUE(waitForTree());
    }
    bool waitForTree() {
        return waitUntil([this] { return !window->tree().isLoading(); });
    }
    /// Copies of samples that may be written.
    std::filesystem::path copyOf(const char* model, const char* database) {
        for (const char* name : {model, database}) {
            const auto from = sampleFile(name);
            std::filesystem::copy_file(from, folder / from.filename(),
                                       std::filesystem::copy_options::overwrite_existing);
        }
        return folder / std::filesystem::path(model).filename();
    }
    /// The ship, a box east of it and a sphere.
    void openThree() {
        openSample();
        addModel(copyOf("box/box.flt", "box/box.sigdb"));
        addModel(copyOf("sphere/sphere.flt", "sphere/sphere.sigdb"));
    }
    QLineEdit* field(const char* name) {
        auto* found = window->findChild<QLineEdit*>(QString("model.") + name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    /// As a person does: the text that is there goes.
    void type(const char* name, const char* text) {
        QLineEdit* edit = field(name);
        edit->setFocus();
        edit->selectAll();
        if (*text == 0) {
            QTest::keyClick(edit, Qt::Key_Delete);
        }
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    QString next() { return workbench.undoStack().undoText(); }
    SceneView* view() { return window->sceneView(); }
    void drag(const QPointF& from, const QPointF& to) {
        const auto at = [](const QPointF& point) { return point.toPoint(); };
        QTest::mouseMove(view(), at(from));
        QTest::mousePress(view(), Qt::LeftButton, {}, at(from));
        for (int i = 1; i <= 4; ++i) {
            QTest::mouseMove(view(), at(from + (to - from) * (i / 4.0)));
        }
        QTest::mouseRelease(view(), Qt::LeftButton, {}, at(to));
    }
    QTreeWidgetItem* itemOf(const QString& text) {
        for (QTreeWidgetItemIterator it(window->findChild<QTreeWidget*>("sceneTree")); *it; ++it) {
            if ((*it)->text(0) == text) {
                return *it;
            }
        }
        return nullptr;
    }
    const ProjectModel& model(std::size_t number) { return workbench.project().models.at(number); }
    bool waitForPicture() {
        return waitUntil([this] {
            const auto* picture = view()->shownPicture();
            return picture != nullptr && !picture->coarse && view()->isUpToDate();
        });
    }
};

} // namespace smat::gui::test

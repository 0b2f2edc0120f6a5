#pragma once

#include <QAbstractItemView>
#include <QLineEdit>
#include <QTabWidget>

#include "gui/database/DatabaseDock.h"
#include "gui/database/NodeEditor.h"
#include "gui/database/NodeTable.h"
#include "gui/database/Nodes.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui::test {

/// The window with the database editor in front, on a copy of a sample that may be written.
class DatabaseFixture : public WindowFixture {
  protected:
    /// Copies model and database of a sample, and opens a project of them with `settings` on top.
    void openCopy(const std::string& sample, const std::map<std::string, std::string>& settings,
                  bool withDatabase = true) {
        namespace fs = std::filesystem;
        const fs::path from = fs::path(SMAT_SOURCE_DIR) / "samples" / sample;
        for (const char* ending : {".flt", ".sigdb"}) {
            if (!withDatabase && std::string(ending) == ".sigdb") {
                continue;
            }
            fs::copy_file(from / (sample + ending), folder / (sample + ending),
                          fs::copy_options::overwrite_existing);
        }
        Project project = projectOfModel(folder / (sample + ".flt"));
        project.settings.set("render.lightError", "0.02");
        for (const auto& [key, value] : settings) {
            project.settings.set(key, value);
        }
        saveProject(project, folder / (sample + ".smat"));
        ASSERT_TRUE(opens(folder / (sample + ".smat")));
        dock().raise();
        QTest::qWait(30);
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    }
    DatabaseDock& dock() { return window->databaseEditor(); }
    DatabaseSession& session() { return workbench.database(); }
    template <typename Widget>
    Widget* find(const char* name, QWidget* within = nullptr) {
        auto* found = (within != nullptr ? within : &dock())->findChild<Widget*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    /// Types into a field as a person does.
    void type(const char* name, const QString& text, QWidget* within = nullptr) {
        auto* field = find<QLineEdit>(name, within);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    /// Raises T0 of the exhaust pipes as a person does.
    void heatPipes(double by_K) {
        int pipes = 0;
        for (const auto& [index, entry] : session().value().temperatures) {
            pipes = entry.name == "exhaust pipes" ? index : pipes;
        }
        dock().select({EntryKind::temperature, pipes});
        chooseTab("temperatureTabs", "Equation terms");
        const double base_K = session().value().temperatures.at(pipes).terms.base_K;
        type("base_K", QString::number(base_K + by_K));
        EXPECT_EQ(session().value().temperatures.at(pipes).terms.base_K, base_K + by_K);
    }
    /// Writes nodes into the table of an editor, cell by cell.
    void fill(QWidget* within, const Nodes& nodes) {
        auto* model = within->findChild<NodeTable*>()->model();
        for (int row = 0; row < static_cast<int>(nodes.size()); ++row) {
            const Node& node = nodes[static_cast<std::size_t>(row)];
            ASSERT_TRUE(model->setData(model->index(row, 0), textOf(node.x), Qt::EditRole));
            ASSERT_TRUE(model->setData(model->index(row, 1), textOf(node.y), Qt::EditRole));
        }
    }
    void chooseTab(const char* tabs, const QString& title) {
        auto* widget = find<QTabWidget>(tabs);
        for (int i = 0; i < widget->count(); ++i) {
            if (widget->tabText(i) == title) {
                widget->setCurrentIndex(i);
                QTest::qWait(10);
                return;
            }
        }
        ADD_FAILURE() << "no tab " << title.toStdString();
    }
    /// The middle of an image analysis run from the window, W m-2 sr-1.
    double middlePixel() {
        runAnalysis("image");
        const auto& image = workbench.results().back().data->image;
        const auto& values = image.primary().values;
        return static_cast<double>(values[values.size() / 2]);
    }
};

} // namespace smat::gui::test

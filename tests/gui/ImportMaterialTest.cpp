// Materials from CSV in the window: as `db import --as material` does it.
#include <fstream>

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <gtest/gtest.h>

#include "irsg/signature/MaterialCsv.h"
#include "tests/gui/DatabaseFixture.h"

namespace smat::gui {
namespace {

class ImportMaterialTest : public test::DatabaseFixture {
  protected:
    void SetUp() override {
        DatabaseFixture::SetUp();
        if (!IsSkipped()) {
            openCopy("box", {});
        }
    }
    void import(const std::string& csv, const std::function<void(QDialog&)>& act) {
        const auto file = folder / "paint.csv";
        std::ofstream(file) << csv;
        chosen = QString::fromStdString(file.string());
        onDialog = act;
        find<QToolButton>("importMaterial")->click();
        onDialog = nullptr;
    }
    static bool canImport(QDialog& dialog) {
        return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled();
    }
};

const std::string good = "um,emissivity,reflectivity\n3,0.9,0.1\n4,0.8,0.2\n5,0.7,0.3\n";

TEST_F(ImportMaterialTest, MakesAnEntryInOneStepAsTheCommandDoes) {
    const irsg::SignatureDatabase before = session().value();
    int index = -1;
    import(good, [&](QDialog& dialog) {
        ASSERT_EQ(dialog.objectName(), "importMaterialDialog");
        index = dialog.findChild<QLineEdit*>("materialIndex")->text().toInt();
        EXPECT_FALSE(before.materials.contains(index)) << "a free one";
        EXPECT_EQ(dialog.findChild<QLineEdit*>("materialName")->placeholderText(), "paint");
        EXPECT_TRUE(dialog.findChild<QLabel*>("outcome")->text().contains(
            "Emissivity: 3 nodes from 3 to 5"))
            << dialog.findChild<QLabel*>("outcome")->text().toStdString();
        EXPECT_TRUE(canImport(dialog));
        test::keepScreenshot(dialog, "database-import-material");
    });
    ASSERT_TRUE(session().value().materials.contains(index));
    EXPECT_EQ(session().value().materials.at(index),
              irsg::importedMaterial(folder / "paint.csv", before, index));
    EXPECT_EQ(workbench.undoStack().undoText(), QString("Import material %1").arg(index));
    EXPECT_EQ(dock().current(), (EntryKey{EntryKind::material, index}));
    trigger("undo");
    EXPECT_EQ(session().value(), before);
}

TEST_F(ImportMaterialTest, KeepsNAndNotesOfAnEntryThatIsThere) {
    const int index = session().value().materials.begin()->first;
    session().edit("prepare", [&](irsg::SignatureDatabase& database) {
        database.materials[index].nAngleFactor = 2.0;
        database.materials[index].notes = "measured in May";
        database.materials[index].name = "skin";
    });
    import(good, [&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("materialIndex")->setText(QString::number(index));
        EXPECT_TRUE(dialog.findChild<QLabel*>("outcome")->text().contains("Replaces"));
    });
    const irsg::Material& material = session().value().materials.at(index);
    EXPECT_EQ(material.name, "skin");
    EXPECT_EQ(material.nAngleFactor, 2.0);
    EXPECT_EQ(material.notes, "measured in May");
    EXPECT_EQ(material.emissivity.wavelengths_um().size(), 3U);
}

TEST_F(ImportMaterialTest, TakesIndexAndTablesFromTheSurfacePageAsTheCommandDoes) {
    const int index = session().value().materials.begin()->first;
    dock().select({EntryKind::material, index});
    for (const auto& [name, text] :
         {std::pair{"index.csv", "wl,n\n3,2\n5,3\n\nwl,k\n3,20\n5,30\n"},
          std::pair{"table.csv", "incidence_deg,3,5\n0,0.2,0.4\n90,1,1\n"}}) {
        const irsg::SignatureDatabase before = session().value();
        const auto file = folder / name;
        std::ofstream(file) << text;
        chosen = QString::fromStdString(file.string());
        onDialog = [&](QDialog& dialog) {
            EXPECT_EQ(dialog.findChild<QLineEdit*>("materialIndex")->text(),
                      QString::number(index));
            test::keepScreenshot(dialog, std::string("database-import-") + name);
        };
        find<QPushButton>("importSurface")->click();
        onDialog = nullptr;
        const irsg::Material& material = session().value().materials.at(index);
        EXPECT_EQ(material, std::string(name) == "table.csv"
                                ? irsg::importedReflectance(file, before, index)
                                : irsg::importedMaterial(file, before, index));
        EXPECT_NE(material, before.materials.at(index));
    }
    EXPECT_EQ(session().value().materials.at(index).surfaceModel, "tabulated");
}

TEST_F(ImportMaterialTest, SaysEachLineThatIsWrongAndTakesNothing) {
    const irsg::SignatureDatabase before = session().value();
    import("um,emissivity,reflectivity\n3,0.9,0.1\n4,abc,0.2\n5,1.7,0.3\n", [&](QDialog& dialog) {
        const QString words = dialog.findChild<QLabel*>("outcome")->text();
        EXPECT_TRUE(words.contains("line 3")) << words.toStdString();
        EXPECT_TRUE(words.contains("abc")) << words.toStdString();
        EXPECT_FALSE(canImport(dialog));
        test::keepScreenshot(dialog, "database-import-material-wrong");
    });
    EXPECT_EQ(session().value(), before);
    import(good, [&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("materialIndex")->setText("three");
        EXPECT_FALSE(canImport(dialog));
    });
    EXPECT_EQ(session().value(), before);
}

} // namespace
} // namespace smat::gui

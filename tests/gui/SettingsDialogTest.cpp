#include "gui/settings/SettingsDialog.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>

#include "gui/analysis/AnalysisGeneratorDialog.h"
#include "smatcore/settings/SettingAvailability.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class SettingsDialogTest : public test::WindowFixture {
  protected:
    static void type(QWidget& dialog, const char* key, const char* text) {
        auto* field = dialog.findChild<QLineEdit*>(key);
        ASSERT_NE(field, nullptr) << key;
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    /// Gives a field another value than it has, by mouse or keys.
    static void change(QWidget& dialog, const SettingInfo& info, const std::string& now) {
        const QString name = QString::fromStdString(info.key);
        auto* field = dialog.findChild<QWidget*>(name);
        ASSERT_NE(field, nullptr) << info.key;
        EXPECT_TRUE(field->isVisible()) << info.key;
        auto* box = qobject_cast<QComboBox*>(field);
        if (auto* check = qobject_cast<QCheckBox*>(field)) {
            check->click();
        } else if (box != nullptr && !box->isEditable()) {
            QTest::keyClick(box, box->currentIndex() == 0 ? Qt::Key_Down : Qt::Key_Up);
        } else {
            auto* edit = box != nullptr ? box->lineEdit() : qobject_cast<QLineEdit*>(field);
            const bool isFile =
                info.kind == SettingKind::path || info.kind == SettingKind::pathList;
            for (const std::string text : {isFile ? "other.csv" : "2", "0.5", "0.05", "8-12"}) {
                if (const auto value = canonicalText(info, text); value && *value != now) {
                    edit->selectAll();
                    QTest::keyClicks(edit, QString::fromStdString(text));
                    return;
                }
            }
            ADD_FAILURE() << info.key << " has no other value";
        }
    }
};

TEST_F(SettingsDialogTest, OptionsAreChangedAppliedUndoneAndReopenedFromTheFile) {
    openSample();
    onDialog = [&](QDialog& dialog) {
        type(dialog, "render.backgroundRows", "32");
        type(dialog, "environment.skyboxSlope", "2.5");
        dialog.findChild<QCheckBox*>("render.sunDisc")->click();
        auto* apply = dialog.findChild<QPushButton*>("apply");
        EXPECT_TRUE(apply->isEnabled());
        apply->click();
        EXPECT_FALSE(apply->isEnabled());
        dynamic_cast<SettingsDialog&>(dialog).accept();
    };
    trigger("options");
    EXPECT_EQ(workbench.undoStack().count(), 1);
    EXPECT_EQ(workbench.undoStack().undoText(), "Change settings");
    EXPECT_EQ(workbench.settings()[key::renderBackgroundRows], 32);
    trigger("undo");
    EXPECT_EQ(workbench.settings()[key::renderBackgroundRows], 0);
    EXPECT_FALSE(workbench.settings()[key::renderSunDisc]);
    trigger("redo");
    trigger("saveProject");
    Workbench again;
    again.open(folder / "ship.smat");
    EXPECT_EQ(again.settings()[key::environmentSkyboxSlope], 2.5);
    EXPECT_TRUE(again.settings()[key::renderSunDisc]);
}

TEST_F(SettingsDialogTest, EverySettingOfTheTableStandsOnOnePage) {
    std::map<std::string, int> times;
    for (const SettingsPage& page : SettingsDialog::pages()) {
        for (const std::string& key : page.keys) {
            ++times[key];
        }
    }
    for (const SettingInfo& info : settingTable()) {
        EXPECT_EQ(times[info.key], isAnalysisSection(info.section()) ? 0 : 1) << info.key;
    }
}

TEST_F(SettingsDialogTest, FieldsOfAPageStandInTheOrderInWhichTheyAreSet) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> expected = {
        {"Band and mode",
         {"sensor.band", "sensor.response", "sensor.mode", "render.widebandError"}},
        {"Sensor", {"sensor.width", "sensor.height", "sensor.fov"}},
        {"Camera and model",
         {"camera.range", "camera.azimuth", "camera.elevation", "target.yaw", "target.pitch",
          "target.roll", "target.altitude", "state.time", "state.power", "state.mach"}},
        {"Sun and fluxes",
         {"environment.sunAzimuth", "environment.sunElevation", "environment.dayOfYear",
          "render.sun", "render.shadows", "render.bounces", "render.lightError",
          "render.ambientReflection", "render.fluxWeights"}},
        {"Atmosphere",
         {"environment.atmospheres", "environment.bins", "environment.ambientTemperature",
          "render.referenceTransmittance"}},
        {"Scattering",
         {"render.scattering", "environment.mtf", "environment.scatteringCoefficient"}},
        {"Background",
         {"render.background", "render.backgroundRows", "render.backgroundColumns",
          "render.sunDisc"}},
        {"Skybox", {"environment.skybox", "environment.skyboxSlope", "environment.skyboxOffset"}},
        {"Terrain",
         {"environment.terrain", "environment.terrainSlope", "environment.terrainOffset",
          "environment.terrainEast", "environment.terrainNorth", "environment.terrainAltitude",
          "render.terrainHides"}},
        {"Antialiasing",
         {"render.antialiasing", "render.errors", "render.parts", "render.targetError",
          "render.supersampling", "render.zoom", "render.pointSource", "render.hotSpots",
          "render.layers", "render.engine"}},
        {"Colours",
         {"display.colorMap", "display.scale", "display.markOutside", "display.minimum",
          "display.maximum"}},
        {"Scalings", {"scaling.use", "scaling.seed"}},
    };
    std::vector<std::pair<std::string, std::vector<std::string>>> pages;
    for (const SettingsPage& page : SettingsDialog::pages()) {
        pages.emplace_back(page.title.toStdString(), page.keys);
    }
    EXPECT_EQ(pages, expected);
}

TEST_F(SettingsDialogTest, IsFoundByAnyOfItsWords) {
    openSample();
    onDialog = [&](QDialog& dialog) {
        auto* list = dialog.findChild<QListWidget*>("pageList");
        const auto pagesShown = [&] {
            QStringList titles;
            for (int i = 0; i < list->count(); ++i) {
                if (!list->item(i)->isHidden()) {
                    titles << list->item(i)->text();
                }
            }
            return titles;
        };
        auto* search = dialog.findChild<QLineEdit*>("settingsSearch");
        QTest::keyClicks(search, "field of view");
        EXPECT_TRUE(pagesShown().contains("Sensor"));
        EXPECT_FALSE(pagesShown().contains("Terrain"));
        EXPECT_TRUE(dialog.findChild<QWidget*>("sensor.fov")->isVisible());
        test::keepScreenshot(dialog, "settings-search");
        search->setText("--layers"); // for experts, by its option
        EXPECT_EQ(pagesShown(), QStringList("Antialiasing"));
        EXPECT_TRUE(dialog.findChild<QWidget*>("render.layers")->isVisible());
        EXPECT_FALSE(dialog.findChild<QWidget*>("render.antialiasing")->isVisible());
        search->clear();
        EXPECT_EQ(pagesShown().size(), list->count());
        EXPECT_FALSE(dialog.findChild<QWidget*>("render.layers")->isVisible());
    };
    trigger("options");
}

TEST_F(SettingsDialogTest, EverySettingIsChangedAppliedUndoneAndReopened) {
    openSample();
    const auto pages = SettingsDialog::pages();
    for (const char* action : {"analysisSettings"}) {
        const Settings before = workbench.settings();
        onDialog = [&](QDialog& dialog) {
            auto& form = dynamic_cast<SettingsDialog&>(dialog);
            if (auto* experts = dialog.findChild<QCheckBox*>("showExperts");
                experts->isVisible() && !experts->isChecked()) {
                experts->click();
            }
            for (std::size_t page = 0; page < pages.size(); ++page) {
                form.showPage(static_cast<int>(page));
                for (const std::string& key : pages[page].keys) {
                    if (whyUnavailable(settingInfo(key)).empty()) {
                        change(dialog, settingInfo(key), before.text(key));
                    }
                }
            }
            dialog.findChild<QPushButton*>("apply")->click();
            form.accept();
        };
        trigger(action);
        const Settings changed = workbench.settings();
        int settings = 0;
        for (const SettingsPage& page : pages) {
            for (const std::string& key : page.keys) {
                if (!whyUnavailable(settingInfo(key)).empty()) {
                    continue;
                }
                EXPECT_NE(changed.text(key), before.text(key)) << key;
                ++settings;
            }
        }
        EXPECT_GE(settings, 8);
        trigger("undo");
        EXPECT_EQ(workbench.settings(), before) << action;
        trigger("redo");
        EXPECT_EQ(workbench.settings(), changed) << action;
        trigger("saveProject");
        Workbench again;
        again.open(folder / "ship.smat");
        // One that was changed to its default is not in the file.
        for (const SettingInfo& info : settingTable()) {
            EXPECT_EQ(again.settings().text(info.key), changed.text(info.key)) << info.key;
        }
        trigger("undo");
    }
}

TEST_F(SettingsDialogTest, ScatteringShowsItsDatabaseOrWhyItCannotBeHad) {
    openSample();
    onDialog = [&](QDialog& dialog) {
        auto& form = dynamic_cast<SettingsDialog&>(dialog);
        form.showPage("Scattering");
        auto* check = dialog.findChild<QCheckBox*>("render.scattering");
        auto* note = dialog.findChild<QLabel*>("mtfNote");
        const QString missing =
            QString::fromStdString(whyUnavailable(settingInfo("render.scattering")));
        EXPECT_EQ(check->isEnabled(), missing.isEmpty());
        if (!missing.isEmpty()) {
            EXPECT_TRUE(missing.contains("irsg/scattering"));
            EXPECT_FALSE(dialog.findChild<QLineEdit*>("environment.mtf")->isEnabled());
            EXPECT_EQ(check->toolTip(), missing);
            EXPECT_TRUE(
                dialog.findChild<QLabel*>("render.scattering.help")->text().contains(missing));
            test::keepScreenshot(dialog, "options-scattering-missing");
            return;
        }
        EXPECT_FALSE(note->isVisible());
        type(dialog, "environment.mtf",
             SMAT_SOURCE_DIR "/resources/scattering/advection-fog-mwir.mtf");
        EXPECT_TRUE(note->isVisible());
        EXPECT_TRUE(note->text().contains("field of view: 60 deg")) << note->text().toStdString();
        check->click();
        // However long the header is, nothing is cut off at the side.
        QTest::qWait(50);
        const auto* scroll =
            dynamic_cast<QScrollArea*>(note->parentWidget()->parentWidget()->parentWidget());
        ASSERT_NE(scroll, nullptr);
        EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width());
        test::keepScreenshot(dialog, "options-scattering");
        type(dialog, "environment.mtf", "none.mtf");
        EXPECT_TRUE(note->text().contains("none.mtf")) << note->text().toStdString();
    };
    trigger("options");
}

TEST_F(SettingsDialogTest, EveryFieldOfEveryAnalysisReachesItsInputAndItsCommand) {
    openSample();
    std::set<std::string> inForms;
    for (const AnalysisKind kind : allAnalysisKinds()) {
        AnalysisGeneratorDialog dialog(workbench.project(), workbench.settings(), kind,
                                       [](const QString&, const QString&) { return QString(); });
        dialog.show();
        auto* pages = dialog.findChild<QTabWidget*>("pages");
        const Settings before = dialog.data().settings;
        std::vector<std::string> changed;
        for (int page = 0; page < pages->count(); ++page) {
            pages->setCurrentIndex(page);
            for (const SettingInfo& info : settingTable()) {
                const auto* field =
                    pages->widget(page)->findChild<QWidget*>(QString::fromStdString(info.key));
                if (field == nullptr) {
                    continue;
                }
                if (!whyUnavailable(info).empty()) {
                    inForms.insert(info.key);
                    continue;
                }
                change(dialog, info, before.text(info.key));
                changed.push_back(info.key);
            }
        }
        const AnalysisData data = dialog.data();
        for (const std::string& key : changed) {
            EXPECT_NE(data.settings.text(key), before.text(key)) << name(kind) << " " << key;
            const auto has = [&data](const std::string& word) {
                return data.commandLine.find(" " + word) != std::string::npos;
            };
            EXPECT_TRUE(has(settingInfo(key).option) || has("--set " + key + "="))
                << key << ": " << data.commandLine;
        }
        inForms.insert(changed.begin(), changed.end());
    }
    for (const SettingInfo& info : settingTable()) {
        EXPECT_EQ(inForms.count(info.key), 1U) << info.key << " is in no form";
    }
}

TEST_F(SettingsDialogTest, TheFormRefusesWhatItsAnalysisCannotDo) {
    openSample();
    const auto problems = [&](AnalysisKind kind) {
        AnalysisGeneratorDialog dialog(workbench.project(), workbench.settings(), kind,
                                       [](const QString&, const QString&) { return QString(); });
        const auto* label = dialog.findChild<QLabel*>("problems");
        return dialog.isAcceptable() ? std::string() : label->text().toStdString();
    };
    EXPECT_EQ(problems(AnalysisKind::polar), "");
    workbench.set("sensor.band", "3-5,8-12");
    EXPECT_EQ(problems(AnalysisKind::polar), "");
    EXPECT_NE(problems(AnalysisKind::image).find("one band for an image"), std::string::npos);
    workbench.set("render.zoom", "sills");
    workbench.set("render.antialiasing", "4"); // of the modes 3 to 5, which have a zoom
    EXPECT_NE(problems(AnalysisKind::polar).find("published zoom"), std::string::npos);
}

TEST_F(SettingsDialogTest, AnImagingSensorIsImportedUndoneWrittenAndReadBack) {
    openSample();
    const std::filesystem::path file = folder / "i.xml";
    const auto writes = [&](const std::string& parameters) {
        std::ofstream(file) << "<data><fileType>Parameters</fileType>"
                               "<type>/ImagingSensor/Root/Sensor/ImagingSensor</type>"
                            << parameters << "</data>";
        chosen = QString::fromStdString(file.string());
    };
    const auto parameter = [](const std::string& name, const std::string& value) {
        return "<parameter name=\"" + name + "\"><double>" + value + "</double></parameter>";
    };
    const Settings before = workbench.settings();
    writes(parameter("CalculationMode", "2") + parameter("AntialiasingMode", "5") +
           parameter("NumberOfBackgroundRows", "7") + parameter("Gain", "3"));
    trigger("importImagingSensor");
    EXPECT_EQ(workbench.settings().text("sensor.mode"), "ck");
    EXPECT_EQ(workbench.settings().text("render.antialiasing"), "5");
    EXPECT_EQ(workbench.settings().text("render.backgroundRows"), "7");
    EXPECT_TRUE(told.join(' ').contains("Gain is no parameter")) << told.join(' ').toStdString();
    EXPECT_EQ(workbench.undoStack().undoText(), "Import imaging sensor i.xml");
    const Settings imported = workbench.settings();
    workbench.undoStack().undo();
    EXPECT_EQ(workbench.settings(), before);
    workbench.undoStack().redo();
    chosen = QString::fromStdString((folder / "o.xml").string());
    told.clear();
    trigger("exportImagingSensor");
    workbench.undoStack().undo();
    trigger("importImagingSensor");
    EXPECT_TRUE(told.isEmpty()) << told.join(' ').toStdString();
    for (const char* key : {"render.antialiasing", "render.backgroundRows", "sensor.mode"}) {
        EXPECT_EQ(workbench.settings().text(key), imported.text(key)) << key;
    }
    // What cannot be is told, and changes nothing.
    const Settings kept = workbench.settings();
    writes(parameter("AntialiasingMode", "6"));
    trigger("importImagingSensor");
    EXPECT_TRUE(told.join(' ').contains("0 to 5")) << told.join(' ').toStdString();
    writes(parameter("UseSkyboxBackground", "1"));
    trigger("importImagingSensor");
    EXPECT_TRUE(told.join(' ').contains("environment.skybox")) << told.join(' ').toStdString();
    EXPECT_EQ(workbench.settings(), kept);
}

TEST_F(SettingsDialogTest, CancelChangesNothing) {
    openSample();
    onDialog = [&](QDialog& dialog) {
        type(dialog, "environment.sunElevation", "12");
        dialog.reject();
    };
    trigger("analysisSettings");
    EXPECT_EQ(workbench.undoStack().count(), 0);
    EXPECT_EQ(workbench.settings()[key::environmentSunElevation], 45.0);
}

TEST_F(SettingsDialogTest, AnalysisSettingsHoldWhatTheDesignNames) {
    openSample();
    onDialog = [&](QDialog& dialog) {
        for (const auto* key : {"environment.sunAzimuth", "environment.sunElevation", "render.sun",
                                "render.ambientReflection", "render.background", "sensor.mode",
                                "sensor.band", "sensor.response"}) {
            EXPECT_NE(dialog.findChild<QWidget*>(key), nullptr) << key;
        }
        auto* sun = dialog.findChild<QComboBox*>("render.sun");
        EXPECT_EQ(sun->count(), 3);
        dynamic_cast<SettingsDialog&>(dialog).showPage("Band and mode");
        EXPECT_TRUE(dialog.findChild<QWidget*>("sensor.mode")->isVisible());
    };
    trigger("analysisSettings");
}

TEST_F(SettingsDialogTest, ChoicesHaveWordsInTheFormAndTheirValueInTheFile) {
    openSample();
    const auto setting = [](const QString& key) { return settingInfo(key.toStdString()); };
    onDialog = [&](QDialog& dialog) {
        for (const QString key : {"render.sun", "render.ambientReflection"}) {
            auto* box = dialog.findChild<QComboBox*>(key);
            const auto forms = dialog.findChildren<SettingForm*>();
            const auto form = std::find_if(forms.begin(), forms.end(), [box](const auto* one) {
                return one->isAncestorOf(box);
            });
            ASSERT_NE(form, forms.end());
            for (int i = 0; i < box->count(); ++i) {
                const auto number = static_cast<std::size_t>(i);
                EXPECT_EQ(box->itemText(i).toStdString(), setting(key).names.at(number));
                box->setCurrentIndex(i);
                EXPECT_EQ((*form)->value(key.toStdString()), setting(key).choices.at(number));
            }
        }
        // What cannot be typed needs no sentence of what may be.
        EXPECT_FALSE(dialog.findChild<QLabel*>("render.sun.help")->text().contains("<i>"));
        EXPECT_TRUE(dialog.findChild<QLabel*>("environment.sunElevation.help")
                        ->text()
                        .contains("<i>A number from -90"));
    };
    trigger("analysisSettings");
}

TEST_F(SettingsDialogTest, RefusesWhatIsNoValueAndSaysWhatWouldBe) {
    openSample();
    onDialog = [&](QDialog& dialog) {
        type(dialog, "environment.sunElevation", "95");
        auto& form = dynamic_cast<SettingsDialog&>(dialog);
        EXPECT_FALSE(form.isAcceptable());
        EXPECT_FALSE(form.apply());
        EXPECT_FALSE(form.findChild<QPushButton*>("apply")->isEnabled());
        EXPECT_TRUE(form.findChild<QLabel*>("problems")->text().contains("from -90 to 90"));
        test::keepScreenshot(dialog, "dialog-analysis-settings-refuses");
    };
    trigger("analysisSettings");
    EXPECT_EQ(workbench.undoStack().count(), 0);
}

TEST_F(SettingsDialogTest, ExpertSettingsWaitUntilTheyAreAskedFor) {
    openSample();
    onDialog = [&](QDialog& dialog) {
        auto* zoom = dialog.findChild<QWidget*>("render.zoom");
        EXPECT_FALSE(zoom->isVisible());
        auto* field = dialog.findChild<QWidget*>("render.antialiasing");
        EXPECT_TRUE(field->isVisible());
        auto* help = dialog.findChild<QLabel*>("render.antialiasing.help");
        EXPECT_TRUE(help->text().contains("512 samples"));
        dialog.findChild<QCheckBox*>("showExperts")->click();
        EXPECT_TRUE(zoom->isVisible());
    };
    trigger("options");
    // One that was changed is never hidden.
    workbench.set("render.zoom", "sills");
    onDialog = [&](QDialog& dialog) {
        EXPECT_TRUE(dialog.findChild<QWidget*>("render.zoom")->isVisible());
    };
    trigger("options");
}

TEST_F(SettingsDialogTest, EveryPageInLightAndDark) {
    openSample();
    for (const auto mode : {ThemeMode::light, ThemeMode::dark}) {
        applyTheme(*qApp, mode);
        const std::string tail = mode == ThemeMode::light ? "-light" : "-dark";
        onDialog = [&](QDialog& dialog) {
            auto* pages = dynamic_cast<SettingsDialog*>(&dialog);
            if (pages == nullptr) {
                return;
            }
            const auto count = SettingsDialog::pages().size();
            for (std::size_t page = 0; page < count; ++page) {
                pages->showPage(static_cast<int>(page));
                QTest::qWait(20);
                const QColor ground = dialog.grab().toImage().pixelColor(2, dialog.height() - 3);
                EXPECT_EQ(ground.lightness() < 128, mode == ThemeMode::dark) << page;
                test::keepScreenshot(dialog, dialog.objectName().toStdString() + "-" +
                                                 std::to_string(page) + tail);
            }
        };
        trigger("options");
        onDialog = [&](QDialog& dialog) {
            test::keepScreenshot(dialog, dialog.objectName().toStdString() + tail);
        };
        accept = false;
        for (const auto* action :
             {"preferences", "showShortcuts", "showAbout", "newProject", "convertModel"}) {
            trigger(action);
        }
        accept = true;
        QTest::qWait(300);
        test::keepScreenshot(*window, "window" + tail);
    }
    applyTheme(*qApp, ThemeMode::light);
}

} // namespace
} // namespace smat::gui

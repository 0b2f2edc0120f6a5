// Every finding that the chapter has a row for, made in a database that is open in the editor: it
// is told there, and has a button where the row says so.
#include <functional>
#include <optional>

#include <QTreeWidget>

#include "gui/database/FindingsPanel.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/ScalingXml.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

using irsg::LookupTable;
using irsg::SignatureDatabase;
using irsg::Spectrum;

constexpr int skin = 1, paint = 1, plume = 6;

struct Row {
    const char* words; ///< of the chapter
    std::function<void(SignatureDatabase&)> spoil;
    const char* place; ///< what the finding's begins with
    const char* told;  ///< value, reason or remedy
    bool hasButton = false;
};

irsg::Material& material(SignatureDatabase& database) {
    return database.materials.at(paint);
}
irsg::TemperatureTerms& terms(SignatureDatabase& database) {
    return database.temperatures.at(skin).terms;
}
irsg::ComponentFactor& factor(SignatureDatabase& database) {
    auto& entry = database.temperatures.at(plume);
    if (entry.factors.empty()) {
        entry.factors.push_back(
            {database.spectra.at(entry.userSpectrum).components.front().name, 1.0, {}, {}});
    }
    return entry.factors.front();
}
irsg::UserSpectrum& core(SignatureDatabase& database) {
    return database.spectra.at("plume core");
}
/// Every curve of the plume, by a rule of wavelength and value.
void change(SignatureDatabase& database, const std::function<double(double, double)>& rule,
            double axisFactor = 1.0) {
    for (auto& component : core(database).components) {
        std::vector<double> axis_um, values;
        for (std::size_t i = 0; i < component.radiance.values().size(); ++i) {
            const double x = component.radiance.wavelengths_um()[i];
            axis_um.push_back(x * axisFactor);
            values.push_back(rule(x, component.radiance.values()[i]));
        }
        component.radiance = Spectrum(axis_um, values, Spectrum::Outside::zero);
    }
}
double planck(double wavelength_um) {
    return irsg::planckRadiance_W_m2_sr_um(wavelength_um, 600.0);
}
void setModel(SignatureDatabase& database, const char* name) {
    material(database).surfaceModel = name;
}

class SignatureChecksWalkTest : public test::GuideFixture {
  protected:
    void SetUp() override {
        GuideFixture::SetUp();
        if (!IsSkipped()) {
            openCopy("turboprop4", {{"sensor.width", "64"},
                                    {"sensor.height", "48"},
                                    {"target.altitude", "1500"},
                                    {"state.power", "0.7"}});
            ASSERT_EQ(session().value().temperatures.at(plume).mode,
                      irsg::EmissionMode::userSpectrum);
        }
    }
    QTreeWidget* findings() { return get<QTreeWidget>("findings", &dock()); }
    QTreeWidgetItem* found(const Row& row) {
        dock().findings()->look();
        for (int i = 0; i < findings()->topLevelItemCount(); ++i) {
            auto* item = findings()->topLevelItem(i);
            const QString all = item->text(1) + " " + item->text(2) + " " + item->text(3) + " " +
                                item->data(0, Qt::UserRole + 1).toString();
            if (item->text(0).startsWith(row.place) && all.contains(row.told)) {
                return item;
            }
        }
        return nullptr;
    }
    std::string all() {
        QString text;
        for (int i = 0; i < findings()->topLevelItemCount(); ++i) {
            const auto* item = findings()->topLevelItem(i);
            text += item->text(0) + ": " + item->text(1) + ": " + item->text(2) + "\n";
        }
        return text.toStdString();
    }
    void go(test::GuideWalk& walk, const std::vector<Row>& rows) {
        const SignatureDatabase before = session().value();
        for (const Row& row : rows) {
            walk.step(row.words);
            session().edit("Spoil it", row.spoil);
            // States and bands of the project are looked for in a thread of their own.
            EXPECT_TRUE(test::waitUntil([&] { return found(row) != nullptr; }, 10.0)) << all();
            auto* item = found(row);
            auto* button = item == nullptr
                               ? nullptr
                               : qobject_cast<QPushButton*>(findings()->itemWidget(item, 3));
            EXPECT_EQ(button != nullptr, row.hasButton);
            if (button != nullptr) {
                const QString place = item->text(0), value = item->text(1);
                button->click();
                auto* left = found(row);
                EXPECT_TRUE(left == nullptr || left->text(0) != place || left->text(1) != value)
                    << all();
            }
            while (workbench.undoStack().canUndo()) {
                workbench.undoStack().undo();
            }
            ASSERT_EQ(session().value(), before);
        }
    }
};

TEST_F(SignatureChecksWalkTest, Materials) {
    test::GuideWalk walk("signature-checks", "Materials");
    const auto emissivity = [](double value) {
        return
            [value](SignatureDatabase& d) { material(d).emissivity = Spectrum::constant(value); };
    };
    const char* const of = "materials.1";
    go(walk,
       {{"a value outside 0 to 1, up to 100 | percent where fractions belong | divide by 100 "
         "(button)",
         emissivity(92.0), of, "percent", true},
        {"a value that passes 0 or 1 by 0.02 at most | noise of a measurement | cut off at 0 and 1 "
         "(button)",
         emissivity(1.015), of, "noise", true},
        {"any other value outside 0 to 1 | a mistake in the numbers | correct them",
         emissivity(-3.0), of, "0 to 1"},
        {"emissivity + transmissivity above 1 | the surface gives off more than it takes in; "
         "reflectivity is what is left of 1, and cannot be negative | lower the transmissivity to "
         "1 "
         "− emissivity (button)",
         [](auto& d) { material(d).transmissivity = Spectrum::constant(0.3); }, of,
         "a sum of at most 1", true}});
    walk.step("imported reflectivity does not close the sum | emissivity + reflectivity + "
              "transmissivity misses 1 by more than 1e-4");
    smat::test::write(folder / "open.csv",
                      "um,emissivity,transmissivity,reflectivity\n3,0.5,0.2,0.3\n5,0.5,0.2,0.31\n");
    chosen = path("open.csv");
    onDialog = [](QDialog& dialog) {
        EXPECT_TRUE(dialog.findChild<QLabel*>("outcome")->text().contains("line 3"))
            << dialog.findChild<QLabel*>("outcome")->text().toStdString();
    };
    accept = false;
    find<QToolButton>("importMaterial")->click();
    accept = true;
    onDialog = nullptr;
    go(walk,
       {{"a spectrum that is zero outside its axis | a surface does not end with its data | hold "
         "the "
         "end values (button)",
         [](auto& d) {
             material(d).emissivity = Spectrum({2.0, 14.0}, {0.5, 0.5}, Spectrum::Outside::zero);
         },
         of, "zero outside", true},
        {"wavelengths outside 0.1 to 200 µm | an axis in nm, cm⁻¹ or m that was taken for µm | "
         "read "
         "the axis otherwise (button)",
         [](auto& d) {
             material(d).emissivity = Spectrum({3400.0, 4000.0, 14000.0}, {0.5, 0.6, 0.7});
         },
         of, "nm", true},
        {"a spectrum that does not cover the band | a picture over this band is refused | add "
         "nodes, "
         "or narrow the band",
         [](auto& d) {
             material(d).emissivity = Spectrum({3.5, 14.0}, {0.5, 0.6});
         },
         of, "a picture over this band is refused"},
        {"N above 100 | cos^N with such an N emits along the normal alone",
         [](auto& d) { material(d).nAngleFactor = 120.0; }, of, "120"},
        {"N beside a surface model | a model says emissivity over angle; N has no effect | 0",
         [](auto& d) {
             setModel(d, "ggx");
             material(d).nAngleFactor = 1.0;
         },
         of, "N has no effect"},
        {"n and k of a Lambertian surface, k without n | they have no effect",
         [](auto& d) { material(d).refractiveIndex = Spectrum::constant(1.5); }, of,
         "n and k of a Lambertian surface"},
        {"an emissivity other than n and k, a table or Shell's model leave along the normal | "
         "these "
         "are used (Kirchhoff's law), the emissivity of the first page is not | set the emissivity "
         "to "
         "what they leave (button)",
         [](auto& d) {
             setModel(d, "ggx");
             material(d).emissivity = Spectrum::constant(0.3);
             material(d).refractiveIndex = Spectrum::constant(1.5);
         },
         of, "along the normal", true},
        {"a reflectance above 1 − t at an angle | the model or the table sends more than falls on "
         "it",
         [](auto& d) {
             setModel(d, "shellTarget");
             material(d).refractiveIndex = Spectrum::constant(1.5);
             material(d).diffuseReflectivity = Spectrum::constant(0.9);
             material(d).volumeReflectivity = Spectrum::constant(0.9);
         },
         of, "above 1 - t"},
        {"a BRDF that is not reciprocal | light from a to b and from b to a differ by more than 2 "
         "% up "
         "to 75°",
         [](auto& d) {
             setModel(d, "sandfordRobertson");
             material(d).emissivity = Spectrum::constant(0.5);
             material(d).grazingFactor = 0.2;
         },
         of, "not reciprocal"},
        {"(emissivity + diffuse reflectivity) / G above 1 − t | Sandford and Robertson's lobe has "
         "nothing left along the normal",
         [](auto& d) {
             setModel(d, "sandfordRobertson");
             material(d).emissivity = Spectrum::constant(0.9);
             material(d).diffuseReflectivity = Spectrum::constant(0.1);
             material(d).grazingFactor = 1.0;
         },
         of, "the lobe has what is left"},
        {"a model without its n and k or its table | shellTarget and tabulated are made of them",
         [](auto& d) { setModel(d, "shellTarget"); }, of, "this model is made of"}});
}

TEST_F(SignatureChecksWalkTest, Temperatures) {
    test::GuideWalk walk("signature-checks", "Temperatures");
    Project project = workbench.project();
    project.analyses = {{.name = "turn", .kind = AnalysisKind::polar}};
    workbench.edit(project, "Name an analysis");
    workbench.undoStack().clear();
    const char* const of = "temperatures.1";
    const auto base = [](double base_K) {
        return [base_K](SignatureDatabase& d) {
            terms(d) = {};
            terms(d).base_K = base_K;
        };
    };
    const auto table = [](LookupTable irsg::TemperatureTerms::*which, const LookupTable& is) {
        return [which, is](SignatureDatabase& d) {
            terms(d) = {};
            terms(d).base_K = 300.0;
            terms(d).*which = is;
        };
    };
    using Terms = irsg::TemperatureTerms;
    go(walk,
       {{"below 200 K at rest | most likely degrees Celsius; at rest means air of 288.15 K, time, "
         "power, Mach number and altitude 0 | add 273.15 to T0 (button)",
         base(27.0), of, "Celsius", true},
        {"above 4000 K at rest or over the tables | hotter than anything that keeps its shape",
         base(9000.0), of, "4000"},
        {"below 100 K where the tables are lowest, or in a state | tables that cool more than "
         "their "
         "entry has",
         table(&Terms::altitude, LookupTable({0, 11000}, {0, -250})), of, "at least 100 K"},
        {"0 K or less | no temperature at all | the same", base(-400.0), of, "above 0 K"},
        {"recovery factor outside 0 to 1 | 0.85 is a laminar and 0.89 a turbulent boundary layer; "
         "89 "
         "is percent | divide by 100 (button)",
         [](auto& d) { terms(d).recoveryFactor = 89.0; }, of, "percent", true},
        {"an altitude table that ends below 30 m | kilometres | multiply its axis by 1000 (button)",
         table(&Terms::altitude, LookupTable({0, 11}, {0, -20})), of, "1000", true},
        {"a Mach table beyond 30 | metres per second | divide its axis by 340.3 (button)",
         table(&Terms::mach, LookupTable({0, 300}, {0, 20})), of, "340.3", true},
        {"a loop that jumps | the last node is the first of the next turn: their values must agree "
         "| "
         "add a node with the first value (button)",
         table(&Terms::time, LookupTable({0, 10}, {0, 20}, true)), of, "first of the next turn",
         true},
        {"a loop over power, altitude, Mach number or angle | only time repeats | switch the loop "
         "mode "
         "off (button)",
         table(&Terms::power, LookupTable({0, 1}, {0, 20}, true)), of, "loop", true},
        {"a table that holds its end value in the states of the analyses | beyond its nodes a "
         "table "
         "keeps its last value | add nodes if that is not meant",
         table(&Terms::power, LookupTable({0, 0.5}, {0, 20})), of, "an end value held"}});
    workbench.database().discard();
}

TEST_F(SignatureChecksWalkTest, UserDefinedSpectra) {
    test::GuideWalk walk("signature-checks", "User-defined spectra");
    const char *const spectrum = "spectra.plume core", *const entry = "temperatures.6";
    const auto angles = [](const LookupTable& is) {
        return [is](SignatureDatabase& d) { factor(d).angle = is; };
    };
    go(walk,
       {{"an unknown spectrum or component | the entry names what the database does not have | "
         "take "
         "the one that differs only by case or signs (button)",
         [](auto& d) { d.temperatures.at(plume).userSpectrum = "Plume Core"; }, entry,
         "take 'plume core'", true},
        {"wavelengths outside 0.1 to 200 µm | nm or cm⁻¹ in a file that says um | read the axis "
         "otherwise (button)",
         [](auto& d) {
             change(
                 d, [](double, double v) { return v; }, 1e-6);
         },
         spectrum, "m taken", true},
        {"peak brightness temperature outside 200 to 4000 K | the wrong unit of radiance: W cm⁻² "
         "taken "
         "for W m⁻² is a factor of 10⁴ | multiply (button)",
         [](auto& d) { change(d, [](double, double v) { return 1e-9 * v; }); }, spectrum, "K",
         true},
        {"a curve that is no grey body's, and read otherwise is one | a density per cm⁻¹ taken for "
         "one "
         "per µm, or the other way round: ν²/10⁴ is 361 at 1900 cm⁻¹, but changes along the axis | "
         "convert (button)",
         [](auto& d) { change(d, [](double x, double) { return planck(x) * x * x / 1e4; }); },
         spectrum, "no grey body's", true},
        {"the curve of a grey body with an emissivity far below 0.001 or above 1 | right shape, "
         "wrong "
         "unit | multiply (button)",
         [](auto& d) { change(d, [](double x, double) { return 1e4 * planck(x); }); }, spectrum,
         "an emissivity of", true},
        {"negative radiance | noise, or a background that was subtracted | set to 0 (button)",
         [](auto& d) { change(d, [](double x, double v) { return x < 4.3 ? -0.001 : v; }); },
         spectrum, "negative", true},
        {"negative factors | a component cannot take radiance away | set to 0 (button)",
         [](auto& d) {
             factor(d).time = LookupTable({0, 1}, {1, -1});
         },
         entry, "at least 0", true},
        {"angles beyond 180° | the angle lies between nose and line of sight: it ends at the tail "
         "| "
         "keep the half from 0 to 180° where the other mirrors it (button)",
         angles(LookupTable({0, 90, 180, 270, 360}, {1, 0.5, 0.2, 0.5, 1})), entry, "mirrors",
         true},
        {"angles that end at π/2 or π | radians | multiply the axis by 57.29578 (button)",
         angles(LookupTable({0, 1.5707963, 3.1415927}, {1, 0.5, 0.2})), entry, "57.29578", true}});
}

TEST_F(SignatureChecksWalkTest, ModelAndScalingFiles) {
    {
        test::GuideWalk walk("signature-checks", "Model and database");
        go(walk,
           {{"no entry for the faces that carry a code | the model cannot be drawn | add an entry "
             "(button): black, at ambient temperature, to be given its real values",
             [](auto& d) { d.materials.erase(paint); }, "materials.1", "carry this code", true},
            {"an entry that no face carries, a spectrum that nothing names | left over, or made "
             "for "
             "another model | delete (button, never by --repair), or leave it",
             [](auto& d) { d.materials[77] = d.materials.at(paint); }, "materials.77",
             "no face carries", true}});
        // Of models that have them: what the loader tells of a model is what lint makes of it.
        walk.step(
            "levels of detail | programs that obey their ranges may show an empty picture from "
            "afar; this one draws the highest detail at every range");
        irsg::ModelUse use;
        use.name = "a.flt";
        use.levelsOfDetail = {"a level that ends at 500 m"};
        use.sharedPlanes = {"2 faces of the codes 1 and 2"};
        const auto told = irsg::lint(SignatureDatabase(), {.models = {use}});
        ASSERT_EQ(told.size(), 2U);
        EXPECT_NE(told[0].remedy.find("highest detail at every range"), std::string::npos);
        walk.step(
            "faces of two codes in one plane | they cover each other; those that come first in "
            "the file are drawn | give them one code");
        EXPECT_NE(told[1].remedy.find("give them one code"), std::string::npos);
        EXPECT_FALSE(told[1].repair);
    }
    test::GuideWalk walk("signature-checks", "Scaling files beside the model");
    const auto model = folder / "turboprop4.flt";
    const auto file = [&](irsg::ScalingKind kind) { return irsg::scalingFile(model, kind); };
    const auto scales = [&](irsg::ScalingKind kind, int index, double min, double max,
                            irsg::DistributionKind how, const std::vector<double>& shape = {}) {
        irsg::ScalingTable table;
        table[index] = {shape.empty() ? irsg::Distribution(how, min, max)
                                      : irsg::Distribution(how, min, max, shape),
                        ""};
        smat::test::write(file(kind), irsg::scalingXml(table));
        // Read again, as when the project is opened.
        ASSERT_TRUE(opens(folder / "turboprop4.smat"));
    };
    const auto isTold = [&](const char* words) {
        EXPECT_TRUE(test::waitUntil(
            [&] {
                return found({"", {}, "", words}) != nullptr;
            },
            5.0))
            << words << "\n"
            << all();
    };
    using Kind = irsg::ScalingKind;
    using How = irsg::DistributionKind;
    walk.step(
        "a line of the file that cannot be read | min above max, a scale below 0, a distribution "
        "or shape parameters that do not exist | correct the file; without it nothing is scaled");
    smat::test::write(file(Kind::temperature), "<parameters>\n<no end\n");
    ASSERT_TRUE(opens(folder / "turboprop4.smat"));
    isTold("without it nothing is scaled");
    std::filesystem::remove(file(Kind::temperature));
    walk.step("emissivity times max above 1 − transmissivity | draws beyond are cut off there");
    scales(Kind::emissivity, paint, 0.9, 1.4, How::uniform);
    isTold("cut off there");
    std::filesystem::remove(file(Kind::emissivity));
    walk.step("a temperature at rest times min or max outside 100 to 4000 K | a scale multiplies "
              "kelvin: 1.01 at 300 K are 3 K");
    scales(Kind::temperature, skin, 95.0, 105.0, How::uniform);
    isTold("divide min and max by 100");
    walk.step(
        "a scale without effect | the index is not in the database, on no face of the model, or "
        "a user-defined spectrum");
    scales(Kind::temperature, 99, 0.9, 1.1, How::uniform);
    isTold("a scale without effect");
    walk.step(
        "nine draws in ten in a hundredth of min to max | the distribution does not reach the "
        "ends");
    scales(Kind::temperature, skin, 0.5, 2.0, How::exponential, {0.5, 0.001});
    isTold("nine draws in ten");
}

} // namespace
} // namespace smat::gui

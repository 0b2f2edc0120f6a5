#include "irsg/signature/SignatureRows.h"

#include <array>

#include "irsg/radiometry/Errors.h"
#include "irsg/signature/EntryJson.h"
#include "irsg/signature/Sha256.h"

namespace irsg {

namespace {

struct Table {
    const char* name;
    const char* columns;
};

// Parents before their children.
constexpr std::array<Table, 13> schema = {{
    {"about", "key TEXT PRIMARY KEY NOT NULL, value TEXT NOT NULL"},
    {"temperature",
     "id INTEGER PRIMARY KEY, name TEXT NOT NULL,"
     " mode TEXT NOT NULL CHECK (mode IN ('temperature', 'userSpectrum')),"
     " base_K REAL NOT NULL, ambient_factor REAL NOT NULL, recovery_factor REAL NOT NULL,"
     " ambient_offset_K REAL NOT NULL, user_spectrum TEXT NOT NULL, notes TEXT NOT NULL"},
    {"temperature_table",
     "temperature INTEGER NOT NULL REFERENCES temperature(id) ON DELETE CASCADE,"
     " term TEXT NOT NULL CHECK (term IN ('time_s', 'power', 'altitude_m', 'mach')),"
     " loop INTEGER NOT NULL CHECK (loop IN (0, 1)), PRIMARY KEY (temperature, term)"},
    {"temperature_node",
     "temperature INTEGER NOT NULL, term TEXT NOT NULL, node INTEGER NOT NULL,"
     " x REAL NOT NULL, value_K REAL NOT NULL, PRIMARY KEY (temperature, term, node),"
     " FOREIGN KEY (temperature, term) REFERENCES temperature_table(temperature, term)"
     " ON DELETE CASCADE"},
    {"factor", "temperature INTEGER NOT NULL REFERENCES temperature(id) ON DELETE CASCADE,"
               " position INTEGER NOT NULL, component TEXT NOT NULL, constant REAL NOT NULL,"
               " PRIMARY KEY (temperature, position)"},
    {"factor_table",
     "temperature INTEGER NOT NULL, position INTEGER NOT NULL,"
     " axis TEXT NOT NULL CHECK (axis IN ('time_s', 'angle_deg')),"
     " loop INTEGER NOT NULL CHECK (loop IN (0, 1)), PRIMARY KEY (temperature, position, axis),"
     " FOREIGN KEY (temperature, position) REFERENCES factor(temperature, position)"
     " ON DELETE CASCADE"},
    {"factor_node", "temperature INTEGER NOT NULL, position INTEGER NOT NULL, axis TEXT NOT NULL,"
                    " node INTEGER NOT NULL, x REAL NOT NULL, factor REAL NOT NULL,"
                    " PRIMARY KEY (temperature, position, axis, node),"
                    " FOREIGN KEY (temperature, position, axis)"
                    " REFERENCES factor_table(temperature, position, axis) ON DELETE CASCADE"},
    {"material", "id INTEGER PRIMARY KEY, name TEXT NOT NULL, emissivity REAL, transmissivity REAL,"
                 " n_angle_factor REAL NOT NULL, notes TEXT NOT NULL"},
    {"material_node",
     "material INTEGER NOT NULL REFERENCES material(id) ON DELETE CASCADE,"
     " property TEXT NOT NULL CHECK (property IN ('emissivity', 'transmissivity')),"
     " node INTEGER NOT NULL, wavelength_um REAL NOT NULL, value REAL NOT NULL,"
     " PRIMARY KEY (material, property, node)"},
    {"user_spectrum", "name TEXT PRIMARY KEY NOT NULL, reference_distance_m REAL NOT NULL,"
                      " imported_unit TEXT NOT NULL, notes TEXT NOT NULL"},
    {"user_spectrum_component",
     "spectrum TEXT NOT NULL REFERENCES user_spectrum(name) ON DELETE CASCADE,"
     " position INTEGER NOT NULL, name TEXT NOT NULL, PRIMARY KEY (spectrum, position)"},
    {"user_spectrum_node",
     "spectrum TEXT NOT NULL, position INTEGER NOT NULL, node INTEGER NOT NULL,"
     " wavelength_um REAL NOT NULL, radiance_W_m2_sr_um REAL NOT NULL,"
     " PRIMARY KEY (spectrum, position, node),"
     " FOREIGN KEY (spectrum, position) REFERENCES user_spectrum_component(spectrum, position)"
     " ON DELETE CASCADE"},
    {"content_hash", "entry TEXT PRIMARY KEY NOT NULL, sha256 TEXT NOT NULL"},
}};

/// One statement, run again and again with other values.
class Insert {
  public:
    Insert(SQLite::Database& file, const std::string& table, int columns)
        : statement_(file, text(table, columns)) {}

    template <typename... Values>
    void operator()(const Values&... values) {
        statement_.reset();
        int column = 0;
        (statement_.bind(++column, values), ...);
        statement_.exec();
    }

  private:
    static std::string text(const std::string& table, int columns) {
        std::string sql = "INSERT INTO " + table + " VALUES (?";
        for (int i = 1; i < columns; ++i) {
            sql += ", ?";
        }
        return sql + ")";
    }

    SQLite::Statement statement_;
};

int nodeNumber(std::size_t i) {
    return static_cast<int>(i);
}

void writeTemperatures(const SignatureDatabase& database, SQLite::Database& file) {
    Insert temperature(file, "temperature", 9);
    Insert table(file, "temperature_table", 3);
    Insert node(file, "temperature_node", 5);
    Insert factorRow(file, "factor", 4);
    Insert factorTable(file, "factor_table", 4);
    Insert factorNode(file, "factor_node", 6);
    for (const auto& [index, entry] : database.temperatures) {
        const TemperatureTerms& terms = entry.terms;
        const bool equation = entry.mode == EmissionMode::temperature;
        temperature(index, entry.name, equation ? "temperature" : "userSpectrum", terms.base_K,
                    terms.ambientFactor, terms.recoveryFactor, terms.ambientOffset_K,
                    entry.userSpectrum, entry.notes);
        for (const auto& [term, values] :
             {std::pair("time_s", &terms.time), std::pair("power", &terms.power),
              std::pair("altitude_m", &terms.altitude), std::pair("mach", &terms.mach)}) {
            if (!values->empty()) {
                table(index, term, values->loop() ? 1 : 0);
            }
            for (std::size_t i = 0; i < values->x().size(); ++i) {
                node(index, term, nodeNumber(i), values->x()[i], values->y()[i]);
            }
        }
        for (std::size_t position = 0; position < entry.factors.size(); ++position) {
            const ComponentFactor& factor = entry.factors[position];
            const int number = nodeNumber(position);
            factorRow(index, number, factor.component, factor.constant);
            for (const auto& [axis, values] :
                 {std::pair("time_s", &factor.time), std::pair("angle_deg", &factor.angle)}) {
                if (!values->empty()) {
                    factorTable(index, number, axis, values->loop() ? 1 : 0);
                }
                for (std::size_t i = 0; i < values->x().size(); ++i) {
                    factorNode(index, number, axis, nodeNumber(i), values->x()[i], values->y()[i]);
                }
            }
        }
    }
}

void writeMaterials(const SignatureDatabase& database, SQLite::Database& file) {
    SQLite::Statement grey(file, "INSERT INTO material VALUES (?, ?, ?, ?, ?, ?)");
    Insert node(file, "material_node", 5);
    for (const auto& [index, material] : database.materials) {
        // A spectral property has no number in its column, but nodes.
        grey.reset();
        grey.clearBindings();
        grey.bind(1, index);
        grey.bind(2, material.name);
        if (material.emissivity.isConstant()) {
            grey.bind(3, material.emissivity.values().front());
        }
        if (material.transmissivity.isConstant()) {
            grey.bind(4, material.transmissivity.values().front());
        }
        grey.bind(5, material.nAngleFactor);
        grey.bind(6, material.notes);
        grey.exec();
        for (const auto& [property, spectrum] :
             {std::pair("emissivity", &material.emissivity),
              std::pair("transmissivity", &material.transmissivity)}) {
            for (std::size_t i = 0; i < spectrum->wavelengths_um().size(); ++i) {
                node(index, property, nodeNumber(i), spectrum->wavelengths_um()[i],
                     spectrum->values()[i]);
            }
        }
    }
}

void writeSpectra(const SignatureDatabase& database, SQLite::Database& file) {
    Insert row(file, "user_spectrum", 4);
    Insert componentRow(file, "user_spectrum_component", 3);
    Insert node(file, "user_spectrum_node", 5);
    for (const auto& [name, spectrum] : database.spectra) {
        row(name, spectrum.referenceDistance_m, spectrum.importedUnit, spectrum.notes);
        for (std::size_t position = 0; position < spectrum.components.size(); ++position) {
            const SpectrumComponent& component = spectrum.components[position];
            componentRow(name, nodeNumber(position), component.name);
            for (std::size_t i = 0; i < component.radiance.size(); ++i) {
                node(name, nodeNumber(position), nodeNumber(i),
                     component.radiance.wavelengths_um()[i], component.radiance.values()[i]);
            }
        }
    }
}

} // namespace

void resetSchema(SQLite::Database& file) {
    for (auto table = schema.rbegin(); table != schema.rend(); ++table) {
        file.exec("DROP TABLE IF EXISTS " + std::string(table->name));
    }
    for (const Table& table : schema) {
        file.exec("CREATE TABLE " + std::string(table.name) + " (" + table.columns + ")");
    }
}

void writeRows(const SignatureDatabase& database, SQLite::Database& file) {
    Insert about(file, "about", 2);
    about("title", database.title);
    about("notes", database.notes);
    writeTemperatures(database, file);
    writeMaterials(database, file);
    writeSpectra(database, file);
    Insert hash(file, "content_hash", 2);
    for (const auto& [entry, text] : canonicalEntries(database)) {
        hash(entry, sha256(text));
    }
}

} // namespace irsg

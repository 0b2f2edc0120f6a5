#include "tools/atmosphere-tables/Command.h"

#include <algorithm>
#include <array>

#include "tools/atmosphere-tables/ContinuumTables.h"
#include "tools/atmosphere-tables/DataTable.h"

namespace smat::tables {

namespace {

void makeOthers(const Folders& folders) {
    const auto source = folders.data / "lowtran";
    const Table visible = readTable(source / "ozone_visible_uv.csv");
    Writer chappuis;
    chappuis.add("wavenumber [cm-1]", visible.column("wavenumber_cm-1"));
    chappuis.add("k [atm-1 cm-1]", visible.column("C8_atm-1_cm-1"));
    chappuis.write(
        folders.out / "continuum-ozone-visible.csv",
        "# Chappuis bands of ozone\n# recipe: the numbers of the source, 13000 to 24000 cm-1\n"
        "# units: cm-1; depth = k times amount (atm-cm)\n# expected error: 5 %\n",
        12999.0, 24001.0);
    const Table warm = readTable(source / "ozone_hartley_huggins.csv");
    Writer huggins;
    huggins.add("wavenumber [cm-1]", warm.column("wavenumber_cm-1"));
    huggins.add("c0 [1e-20 cm2]", warm.column("c0_1e-20cm2"));
    huggins.add("c1 [K-1]", warm.column("c1_K-1"));
    huggins.add("c2 [K-2]", warm.column("c2_K-2"));
    huggins.write(folders.out / "continuum-ozone-huggins.csv",
                  "# Hartley and Huggins bands of ozone\n# recipe: the numbers of the source\n"
                  "# units: cm-1; cross section c0 (1 + c1 t + c2 t^2), t = T - 273.15 K\n# "
                  "expected error: 3 %\n",
                  0.0, 1e9);
    const Table far = readTable(source / "ozone_uv.csv");
    Writer ultraviolet;
    ultraviolet.add("wavenumber [cm-1]", far.column("wavenumber_cm-1"));
    ultraviolet.add("sigma [1e-20 cm2]", far.column("sigma_1e-20cm2"));
    ultraviolet.write(folders.out / "continuum-ozone-ultraviolet.csv",
                      "# Ozone in the far ultraviolet\n# recipe: the numbers of the source\n"
                      "# units: cm-1; cross section\n# expected error: 3 %\n",
                      0.0, 1e9);

    const Table acid = readTable(source / "hno3.csv");
    std::array<std::vector<double>, 2> columns;
    for (double nu = 845.0; nu <= 1740.0; nu += 5.0) {
        const auto& axis = acid.column("wavenumber_cm-1");
        const auto found = std::ranges::find(axis, nu);
        columns[0].push_back(nu);
        columns[1].push_back(found == axis.end()
                                 ? 0.0
                                 : acid.columns[1][static_cast<std::size_t>(found - axis.begin())]);
    }
    Writer hno3;
    hno3.add("wavenumber [cm-1]", columns[0]);
    hno3.add("k [atm-1 cm-1]", columns[1]);
    hno3.write(
        folders.out / "continuum-nitric-acid.csv",
        "# Three bands of nitric acid\n# recipe: the numbers of the source, 0 between the bands\n"
        "# units: cm-1; depth = k times amount (atm-cm)\n# expected error: 20 %\n",
        0.0, 1e9);
}

} // namespace

void makeContinuum(const Folders& folders) {
    makeWaterContinuum(folders);
    makeNitrogenContinuum(folders);
    makeOxygenContinuum(folders);
    makeOthers(folders);
}

} // namespace smat::tables

#pragma once

#include <map>
#include <string>

#include "irsg/geometry/conversion/ModelNames.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// What a model itself calls the faces of an index, for the entries of a new database.
class IndexNames {
  public:
    IndexNames() = default;
    /// Each index has the name of the material, object or group whose faces are most nearly those
    /// of the index: faces of both over faces of either, counted in polygons, more than one half,
    /// so that no name is given twice. Identifiers that modellers give by themselves ("g12", "o3")
    /// are none.
    explicit IndexNames(const NamesOfKinds& names);

    /// "temperature 7" and "material 7" where the model has no name for it.
    std::string ofTemperature(int index) const;
    std::string ofMaterial(int index) const;

  private:
    std::map<int, std::string> temperatures_, materials_;
};

/// A database with an entry for each code of a model: opaque black surfaces at ambient temperature,
/// to be given their real values.
SignatureDatabase blackDatabase(const std::map<IrCodes, CodeUse>& codes, const IndexNames& names,
                                const std::string& title);

} // namespace irsg

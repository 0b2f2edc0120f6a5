#include "irsg/geometry/reading/NoFaces.h"

#include "irsg/core/Errors.h"

namespace irsg {

void refuseWithoutFaces(const std::string& file, const std::vector<std::string>& remarks) {
    std::string said;
    for (const std::string& remark : remarks)
        said += (said.empty() ? " (" : "; ") + remark;
    throw InputError(
        {file, "",
         "a model without any visible face that has an area" + said + (said.empty() ? "" : ")"),
         "at least one triangle"});
}

} // namespace irsg

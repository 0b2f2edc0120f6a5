#pragma once

#include <string>
#include <utility>

#include "irsg/core/Errors.h"

namespace smat::test {

/// What the InputError of an action says; "nothing was refused" where it threw none.
template <typename Action>
std::string refusalOf(Action&& action) {
    try {
        std::forward<Action>(action)();
    } catch (const irsg::InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

} // namespace smat::test

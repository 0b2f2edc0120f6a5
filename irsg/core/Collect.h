#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

/// Does `work`; what an InputError has to say is added to `diagnostics`, so that all that is wrong
/// is said at once. Other exceptions pass.
template <typename Work>
void collect(std::vector<Diagnostic>& diagnostics, const Work& work) {
    try {
        work();
    } catch (const InputError& error) {
        diagnostics.insert(diagnostics.end(), error.diagnostics().begin(),
                           error.diagnostics().end());
    }
}

/// The same; `edit` changes each diagnostic before it is added.
template <typename Work, typename Edit>
void collect(std::vector<Diagnostic>& diagnostics, const Work& work, const Edit& edit) {
    std::vector<Diagnostic> found;
    collect(found, work);
    for (Diagnostic& one : found) {
        edit(one);
        diagnostics.push_back(std::move(one));
    }
}

/// What `work` gives; `edit` changes each diagnostic of an InputError on its way.
template <typename Work, typename Edit>
auto editing(const Work& work, const Edit& edit) {
    try {
        return work();
    } catch (const InputError& error) {
        std::vector<Diagnostic> diagnostics = error.diagnostics();
        std::ranges::for_each(diagnostics, edit);
        throw InputError(std::move(diagnostics));
    }
}

/// As collect; what is in `diagnostics` already, word for word, is not said again.
template <typename Work>
void collectOnce(std::vector<Diagnostic>& diagnostics, const Work& work) {
    std::vector<Diagnostic> found;
    collect(found, work);
    for (Diagnostic& one : found) {
        const auto isSame = [&](const Diagnostic& other) {
            return other.message() == one.message();
        };
        if (std::ranges::none_of(diagnostics, isSame))
            diagnostics.push_back(std::move(one));
    }
}

} // namespace irsg

#include "irsg/geometry/reading/sandbox/ReaderMessages.h"

#include <algorithm>

namespace irsg {

ByteSink refusalBytes(const std::vector<Diagnostic>& diagnostics) {
    ByteSink sink;
    sink.putCount(diagnostics.size());
    for (const Diagnostic& diagnostic : diagnostics)
        for (const auto* text :
             {&diagnostic.file, &diagnostic.position, &diagnostic.value, &diagnostic.expected})
            sink.putText(*text);
    return sink;
}

void throwRefusal(std::string_view answer) {
    ByteSource source(answer);
    std::vector<Diagnostic> diagnostics(source.getCount(32));
    for (Diagnostic& diagnostic : diagnostics)
        for (auto* text :
             {&diagnostic.file, &diagnostic.position, &diagnostic.value, &diagnostic.expected})
            *text = source.getText();
    if (diagnostics.empty() || std::ranges::any_of(diagnostics, [](const Diagnostic& diagnostic) {
            return diagnostic.value.empty() && diagnostic.expected.empty();
        }))
        throw DamagedBytes("a refusal without a reason");
    throw InputError(std::move(diagnostics));
}

} // namespace irsg

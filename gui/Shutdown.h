#pragma once

namespace smat::gui {

class Workbench;

/// What the end of the program waits for, once its window is gone: a moment. Threads that still
/// read a model, or draw, do it for nobody; where they do not end by themselves the process ends
/// with `code` here, in their midst. What is written comes into being whole or not at all, so
/// nothing is damaged by that. Returns where all threads rest.
void shutDown(Workbench& workbench, int code);

} // namespace smat::gui

#pragma once

namespace irsg {

/// True in a process that serves: there OpenSceneGraph reads, and nowhere else.
bool isReader();

/// Answers questions through a socket until nobody asks any more, with all that shutIn() takes.
void serveReadings(int socket);

} // namespace irsg

#pragma once

#include <QIcon>

namespace stipple {

/// An icon of resources/icons in the text color of the present palette, dark where it lies on the accent.
QIcon iconOf(const char* name);

}  // namespace stipple

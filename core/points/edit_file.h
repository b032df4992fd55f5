#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/points/edit.h"

namespace stipple {

/// All of an edit, on which side it is too, in the byte order of the machine.
std::vector<std::byte> formatEdit(const Edit& edit);

/// Who wrote the bytes. The topology that reverting restores is known to the program that wrote them only;
/// edits of another get one of their own.
enum class EditWriter { kThisProgram, kAnotherProgram };

/// The edit, which leads between the same states bit for bit. Throws InvalidInput where the bytes are not an
/// edit: whatever they hold, nothing is read or allocated beyond them, and what is returned can be applied to
/// any point set or says that it does not fit.
Edit parseEdit(std::span<const std::byte> bytes, EditWriter writer);

}  // namespace stipple

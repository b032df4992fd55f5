#pragma once

#include <QString>
#include <exception>

namespace stipple {

/// What an error says, as a sentence for the user.
inline QString sentenceOf(const std::exception& error) {
  QString text = QString::fromStdString(error.what());
  if (!text.endsWith('.')) text += '.';
  return text;
}

}  // namespace stipple

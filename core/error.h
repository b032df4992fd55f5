#pragma once

#include <stdexcept>
#include <string>

namespace stipple {

/// Common base: what() is one clear sentence that names the thing and its value.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller or a file gave something that cannot be used: "radius[17] is -0.2, expected > 0".
class InvalidInput : public Error {
 public:
  using Error::Error;
};

/// A numerical method failed: not positive definite, no convergence.
class SolverError : public Error {
 public:
  using Error::Error;
};

/// The disk or the system refused: missing, unreadable, full.
class IoError : public Error {
 public:
  using Error::Error;
};

/// The user asked to stop. Nothing was changed.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace stipple

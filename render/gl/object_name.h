#pragma once

#include <utility>

namespace stipple::gl {

/// The driver's name of an object, deleted with its owner; 0: none.
template <void (*destroy)(unsigned)>
class ObjectName {
 public:
  ObjectName() = default;
  explicit ObjectName(unsigned name) : name_(name) {}
  ObjectName(ObjectName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  ObjectName& operator=(ObjectName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~ObjectName() {
    if (name_ != 0) destroy(name_);
  }

  unsigned get() const { return name_; }

 private:
  unsigned name_ = 0;
};

}  // namespace stipple::gl

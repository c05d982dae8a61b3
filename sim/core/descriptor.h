#pragma once

#include <unistd.h>

#include <cerrno>
#include <utility>

namespace griffith {

/// An open file of the operating system, closed at the end.
class Descriptor {
 public:
  /// `number`: what open() gave; negative where it failed.
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  /// Closes it now; false, with errno, where the system reports only here that a write has failed.
  bool close() { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0 || errno == EINTR; }

 private:
  int number_;
};

}  // namespace griffith

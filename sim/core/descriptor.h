#pragma once

#include <unistd.h>

#include <cerrno>
#include <utility>

namespace griffith {

/// File descriptor of the operating system, closed by the destructor.
class Descriptor {
 public:
  /// `number`: the result of open(), negative if it failed.
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  /// Closes the file now. Returns false and sets errno if an earlier write turns out to have failed.
  bool close() { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0 || errno == EINTR; }

 private:
  int number_;
};

}  // namespace griffith

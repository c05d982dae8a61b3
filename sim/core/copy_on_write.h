#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace griffith {

/// A value that copies share until one of them is to change. As with any value, one thread at a time may call what is
/// not const, and any number what is const, copying included; copies may go to other threads. A reference from `*` or
/// `->` shows the value as it was when edit() has been called since.
template <class T>
class CopyOnWrite {
 public:
  CopyOnWrite() : value_(std::make_shared<T>()) {}
  explicit CopyOnWrite(T value) : value_(std::make_shared<T>(std::move(value))) {}
  CopyOnWrite(const CopyOnWrite& other) : value_(other.share()), is_shared_(true) {}
  CopyOnWrite(CopyOnWrite&& other) noexcept : value_(std::move(other.value_)), is_shared_(other.is_shared()) {}
  CopyOnWrite& operator=(const CopyOnWrite& other) { return *this = CopyOnWrite(other); }
  CopyOnWrite& operator=(CopyOnWrite&& other) noexcept {
    value_ = std::move(other.value_);
    is_shared_.store(other.is_shared(), std::memory_order_relaxed);
    return *this;
  }

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }
  operator const T&() const { return *value_; }
  /// The value to be changed, of this copy alone. The first call after copying makes it so and belongs before a
  /// parallel loop; later ones may be in it.
  T& edit() {
    if (is_shared()) *this = CopyOnWrite(T(*value_));
    return *value_;
  }
  /// Whether both hold one value between them.
  bool shares_with(const CopyOnWrite& other) const { return value_ == other.value_; }

 private:
  // How many share the value now is not asked: another thread might just be done reading what would be changed. What
  // was copied once counts as shared.
  bool is_shared() const { return is_shared_.load(std::memory_order_relaxed); }
  const std::shared_ptr<T>& share() const {
    is_shared_.store(true, std::memory_order_relaxed);
    return value_;
  }

  std::shared_ptr<T> value_;
  mutable std::atomic<bool> is_shared_ = false;
};

/// An array that copies share until one of them is to change: reads as a constant std::vector.
template <class T>
class SharedArray : public CopyOnWrite<std::vector<T>> {
 public:
  const T* data() const { return (*this)->data(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  std::size_t size() const { return (*this)->size(); }
  bool empty() const { return (*this)->empty(); }
  const T& back() const { return (*this)->back(); }
  template <class Index>
  const T& operator[](Index index) const {
    return (**this)[index];
  }
};

}  // namespace griffith

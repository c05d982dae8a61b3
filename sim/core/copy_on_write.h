#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace griffith {

/// Value that copies share until one of them changes. Threads may use it like any other value: one at a time calls
/// members that are not const, any number call const ones, and copies may go to other threads. A reference from `*` or
/// `->` still shows the old value after edit().
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
  /// Returns the value, owned by this copy alone, to be changed. The first call after a copy allocates, so it belongs
  /// before a parallel loop. Later calls may be inside the loop.
  T& edit() {
    if (is_shared()) *this = CopyOnWrite(T(*value_));
    return *value_;
  }
  /// True if both share one value.
  bool shares_with(const CopyOnWrite& other) const { return value_ == other.value_; }

 private:
  // The present number of owners is not asked, since another thread may still be reading the value. A value that was
  // copied once counts as shared.
  bool is_shared() const { return is_shared_.load(std::memory_order_relaxed); }
  const std::shared_ptr<T>& share() const {
    is_shared_.store(true, std::memory_order_relaxed);
    return value_;
  }

  std::shared_ptr<T> value_;
  mutable std::atomic<bool> is_shared_ = false;
};

/// Array that copies share until one of them changes. Reads like a constant std::vector.
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

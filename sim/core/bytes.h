#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// Plain values as bytes in memory, for files that only the same machine reads back.

namespace griffith {

template <class T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}
template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return bytes_of(std::span<const T>(values));
}

/// Removes `count` values from the front of `bytes`. Returns false if there are fewer.
template <class T>
bool take(std::string_view& bytes, T* values, std::int64_t count) {
  if (count < 0 || count > std::ssize(bytes) / static_cast<std::int64_t>(sizeof(T))) return false;
  const auto size = static_cast<std::size_t>(count) * sizeof(T);
  if (size > 0) std::memcpy(static_cast<void*>(values), bytes.data(), size);
  bytes.remove_prefix(size);
  return true;
}

/// Removes `count` values from the front of `bytes`. Returns false, before any allocation, if there are fewer.
template <class Values>
bool take_values(std::string_view& bytes, Values& values, std::int64_t count) {
  constexpr auto kSize = static_cast<std::int64_t>(sizeof values[0]);
  if (count < 0 || count > std::ssize(bytes) / kSize) return false;
  values.resize(static_cast<std::size_t>(count));
  return take(bytes, values.data(), count);
}

}  // namespace griffith

#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace griffith {

/// Unsigned integers of the width of container subscripts.
template <class T>
concept Subscript = std::unsigned_integral<T> && sizeof(T) == sizeof(std::size_t);

/// Typed index into one kind of array. Arrays take it directly, `positions[node]`; its number is `index()`. It has no
/// arithmetic and compares only with ids of its own kind. Ids are stable: nodes and bodies are only appended.
template <class Tag>
class Id {
 public:
  /// Invalid id (-1): a missing neighbor, an empty selection.
  constexpr Id() = default;
  constexpr explicit Id(std::int64_t index) : index_(static_cast<std::int32_t>(index)) {}

  constexpr bool valid() const { return index_ >= 0; }
  constexpr std::int32_t index() const { return index_; }
  /// Returns the id after its arrays were appended to others, where they begin at `first`.
  constexpr Id shifted(Id first) const { return Id(std::int64_t{first.index_} + index_); }
  /// For subscripts only. A template prevents further standard conversions, for example to int. Its two result types
  /// make arithmetic ambiguous.
  template <Subscript T>
  constexpr operator T() const {
    return static_cast<std::size_t>(index_);
  }

  constexpr bool operator==(const Id&) const = default;
  constexpr auto operator<=>(const Id&) const = default;

 private:
  std::int32_t index_ = -1;
};

/// Deleted, since streams would print it as a subscript, and the invalid id as a huge number.
template <class Stream, class Tag>
void operator<<(Stream&, Id<Tag>) = delete;

/// Ids from `begin` up to, but not including, `end`, for loops: `for (const TetId tet : IdRange<TetId>(0, count))`.
template <class Identifier>
class IdRange {
 public:
  class Iterator {
   public:
    constexpr explicit Iterator(std::int64_t index) : index_(index) {}
    constexpr Identifier operator*() const { return Identifier(index_); }
    constexpr Iterator& operator++() { return ++index_, *this; }
    constexpr bool operator==(const Iterator&) const = default;

   private:
    std::int64_t index_;
  };

  constexpr IdRange(std::int64_t begin, std::int64_t end) : begin_(begin), end_(begin < end ? end : begin) {}
  constexpr Iterator begin() const { return begin_; }
  constexpr Iterator end() const { return end_; }

 private:
  Iterator begin_, end_;
};

using NodeId = Id<struct NodeTag>;
using TetId = Id<struct TetTag>;
using BodyId = Id<struct BodyTag>;

}  // namespace griffith

template <class Tag>
struct std::hash<griffith::Id<Tag>> {
  std::size_t operator()(griffith::Id<Tag> id) const noexcept { return std::hash<std::int32_t>{}(id.index()); }
};

#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace griffith {

/// Unsigned integers as wide as those that containers take.
template <class T>
concept Subscript = std::unsigned_integral<T> && sizeof(T) == sizeof(std::size_t);

/// A typed index into one kind of array. Arrays take it as it is, `positions[node]`; as a number it is `index()`. It
/// does no arithmetic and compares with ids of its own kind alone. Ids are stable: nodes and bodies are only ever
/// appended.
template <class Tag>
class Id {
 public:
  /// The id of nothing (-1): a missing neighbour, an empty selection.
  constexpr Id() = default;
  constexpr explicit Id(std::int64_t index) : index_(static_cast<std::int32_t>(index)) {}

  constexpr bool valid() const { return index_ >= 0; }
  constexpr std::int32_t index() const { return index_; }
  /// Its id once its arrays are appended to others, where they begin at `first`.
  constexpr Id shifted(Id first) const { return Id(std::int64_t{first.index_} + index_); }
  /// For subscripts alone. No standard conversion follows a template, to int say, and that it gives two types makes
  /// operators of numbers ambiguous.
  template <Subscript T>
  constexpr operator T() const {
    return static_cast<std::size_t>(index_);
  }

  constexpr bool operator==(const Id&) const = default;
  constexpr auto operator<=>(const Id&) const = default;

 private:
  std::int32_t index_ = -1;
};

/// Streams would take it for a subscript, and print the id of nothing as a huge number.
template <class Stream, class Tag>
void operator<<(Stream&, Id<Tag>) = delete;

/// The ids from `begin` up to but without `end`, in a loop: `for (const TetId tet : IdRange<TetId>(0, count))`.
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

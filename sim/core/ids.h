#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <type_traits>

namespace griffith {

/// A typed index into one kind of array. It converts to a plain index for look-up, but an id of one kind never
/// converts to an id of another. Ids are stable: nodes and bodies are only ever appended.
template <class Tag>
struct Id {
  std::int32_t value = -1;

  constexpr Id() = default;
  constexpr explicit Id(std::int64_t index) : value(static_cast<std::int32_t>(index)) {}
  constexpr operator std::int32_t() const { return value; }
  /// False for the id of nothing (-1): a missing neighbour, an empty selection.
  constexpr bool valid() const { return value >= 0; }
  constexpr bool operator==(const Id&) const = default;
  constexpr auto operator<=>(const Id&) const = default;
};

/// Ids of different kinds are never compared.
template <class A, class B>
requires(!std::is_same_v<A, B>) bool operator==(Id<A>, Id<B>) = delete;
template <class A, class B>
requires(!std::is_same_v<A, B>) std::strong_ordering operator<=>(Id<A>, Id<B>) = delete;

using NodeId = Id<struct NodeTag>;
using TetId = Id<struct TetTag>;
using BodyId = Id<struct BodyTag>;

}  // namespace griffith

template <class Tag>
struct std::hash<griffith::Id<Tag>> {
  std::size_t operator()(griffith::Id<Tag> id) const noexcept { return std::hash<std::int32_t>{}(id.value); }
};

#pragma once

#include "tests/fuzz/sandbox.h"

namespace griffith::fuzz {

/// Returns a smaller input that fails in the same way, by removing parts of its files as long as it still does: values
/// of a JSON text, lines and ranges of others. Ends after some seconds with the smallest so far.
Input minimized(Sandbox& sandbox, const Target& target, Input input, const Failure& failure);

}  // namespace griffith::fuzz

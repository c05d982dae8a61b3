#pragma once

#include "tests/fuzz/sandbox.h"

namespace griffith::fuzz {

/// A smaller input that fails in the same way, found by taking away parts of its files as long as that does: values of
/// a JSON text, lines and stretches of others. Ends after some seconds with the smallest so far.
Input minimized(Sandbox& sandbox, const Target& target, Input input, const Failure& failure);

}  // namespace griffith::fuzz

#pragma once

#include <string>

#include "sim/core/error.h"

namespace griffith {

/// Returns the message of the InputError that `work` throws, or "no error".
template <class Work>
std::string input_error_of(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace griffith

#pragma once

#include <griffith/griffith.h>

#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sim/core/error.h"
#include "sim/core/monitor.h"

namespace griffith::c {

/// A null pointer, an index out of range or an unknown name passed by the caller.
class ArgumentError : public InputError {
 public:
  using InputError::InputError;
};

/// Throws ArgumentError unless the condition on an argument holds.
inline void require(bool holds, const char* argument, const char* problem, const char* remedy = "") {
  if (!holds) throw ArgumentError(argument, problem, remedy);
}

/// Returns the object behind a pointer. Throws ArgumentError if it is null.
template <class T>
T& object_of(T* pointer, const char* argument) {
  require(pointer != nullptr, argument, "is null", "pass an object that the library made");
  return *pointer;
}

/// Returns the text behind a pointer. Throws ArgumentError if it is null.
inline std::string text_of(const char* text, const char* argument) {
  require(text != nullptr, argument, "is null", "pass zero-terminated UTF-8 text");
  return text;
}

/// Copies a text into an array; a longer one is truncated before a UTF-8 character.
template <std::size_t N>
void copy_text(std::string_view text, char (&to)[N]) {
  constexpr std::string_view kCut = "…";
  std::size_t length = text.size();
  if (length >= N) {
    length = N - 1 - kCut.size();
    while (length > 0 && (text[length] & 0xC0) == 0x80) --length;
    std::memcpy(to + length, kCut.data(), kCut.size());
    to[length + kCut.size()] = 0;
  } else {
    to[length] = 0;
  }
  std::memcpy(to, text.data(), length);
}

/// Fills `error`, which may be null, and returns its status.
inline griffith_status fail(griffith_error* error, griffith_status status, std::string_view where,
                            std::string_view problem, std::string_view remedy) {
  if (error) {
    error->status = status;
    copy_text(where, error->where);
    copy_text(problem, error->problem);
    copy_text(remedy, error->remedy);
  }
  return status;
}

/// Calls `body`; exceptions become a status and fill `error`, which may be null.
template <class Body>
griffith_status guarded(griffith_error* error, const Body& body) {
  try {
    body();
    return fail(error, GRIFFITH_OK, "", "", "");
  } catch (const ArgumentError& wrong) {
    return fail(error, GRIFFITH_INVALID_ARGUMENT, wrong.where(), wrong.problem(), wrong.remedy());
  } catch (const InputError& wrong) {
    return fail(error, GRIFFITH_INPUT_ERROR, wrong.where(), wrong.problem(), wrong.remedy());
  } catch (const Cancelled&) {
    return fail(error, GRIFFITH_CANCELLED, "", "cancelled", "");
  } catch (const std::bad_alloc&) {
    return fail(error, GRIFFITH_OUT_OF_MEMORY, "", "out of memory", "use a coarser mesh or fewer bodies");
  } catch (const std::exception& fault) {
    return fail(error, GRIFFITH_INTERNAL_ERROR, "griffith", fault.what(), "");
  } catch (...) {
    return fail(error, GRIFFITH_INTERNAL_ERROR, "griffith", "an unknown exception", "");
  }
}

}  // namespace griffith::c

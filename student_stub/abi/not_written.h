#pragma once

#include <exception>

namespace ex03 {

/// Thrown by the stand-ins for a function that the submission does not define.
struct NotWritten final : std::exception {
    const char* what() const noexcept override { return "not defined in this file"; }
};

} // namespace ex03

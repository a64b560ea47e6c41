// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_RUNTIME_YAML_REFUSAL_HPP
#define TESTS_RUNTIME_YAML_REFUSAL_HPP

#include "runtime/yaml/document.hpp"

#include <string>

namespace counterpoint::runtime::test
{
/// The line that `read` is refused with; empty where it is not.
template <typename Read> std::string RefusalOf(const Read& read)
{
    try
    {
        static_cast<void>(read());
    }
    catch (const YamlError& error)
    {
        return error.what();
    }
    return "";
}
} // namespace counterpoint::runtime::test

#endif // TESTS_RUNTIME_YAML_REFUSAL_HPP

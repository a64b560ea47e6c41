// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_JSON_TEXT_HPP
#define RUNTIME_CONSOLE_JSON_TEXT_HPP

#include <nlohmann/json.hpp>

#include <string>

namespace counterpoint::runtime
{
/// The document as text with a line end. Bytes that are no UTF-8 (file names, Latin-1 texts of an EDS) are replaced.
[[nodiscard]] inline std::string JsonText(const nlohmann::ordered_json& document)
{
    return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}
/// The same as one line.
[[nodiscard]] inline std::string OneLine(const nlohmann::ordered_json& document)
{
    return document.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_JSON_TEXT_HPP

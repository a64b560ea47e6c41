// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/json_pieces.hpp"

#include <string>

namespace counterpoint::campaign
{
namespace
{
constexpr int kStep = 2;

/// A value as it stands two steps further to the right. Lines end in strings as two characters.
std::string Indented(const nlohmann::ordered_json& value)
{
    std::string text = "    ";
    for (const char character : value.dump(kStep))
    {
        text += character;
        text += (character == '\n') ? "    " : "";
    }
    return text;
}
} // namespace

void WriteWithSurvivors(const nlohmann::ordered_json& report, const std::size_t count,
                        const std::function<nlohmann::ordered_json(std::size_t)>& survivor,
                        const cia306::TextPiece& write)
{
    std::string head = report.dump(kStep);
    head.resize(head.size() - 2U); // Without the last brace, and the line before it.
    write(head + ",\n  \"survivors\": [");
    for (std::size_t index = 0U; index < count; ++index)
    {
        write((index == 0U) ? "\n" : ",\n");
        write(Indented(survivor(index)));
    }
    write((count == 0U) ? "]\n}\n" : "\n  ]\n}\n");
}
} // namespace counterpoint::campaign

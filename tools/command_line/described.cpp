// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/described.hpp"

#include <variant>

namespace counterpoint::tools
{
DescribedCommand Described(const CommandRow& row)
{
    DescribedCommand described{row.name, row.description, row.make(), std::make_unique<Options>()};
    described.command->Describe(*described.options);
    return described;
}

bool IsPositional(const Option& option)
{
    return option.name.rfind('-', 0U) != 0U;
}

bool TakesValue(const Option& option)
{
    return !std::holds_alternative<bool*>(option.target);
}

std::string ValueName(const Option& option)
{
    if (!TakesValue(option) || IsPositional(option))
    {
        return "";
    }
    return option.type.value_or(std::holds_alternative<int*>(option.target) ? "N" : "TEXT");
}

std::vector<std::string> ValuesOf(const Option& option)
{
    std::vector<std::string> values = option.words;
    for (const int number : option.numbers)
    {
        values.push_back(std::to_string(number));
    }
    return values;
}

bool TakesFile(const Option& option)
{
    const std::string type = option.type.value_or("");
    const bool is_number = std::holds_alternative<int*>(option.target) || type == "N" || type == "MS";
    return TakesValue(option) && !is_number && ValuesOf(option).empty() && option.problem != &ProblemOfAddress;
}
} // namespace counterpoint::tools

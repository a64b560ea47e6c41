// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/options.hpp"

#include <algorithm>

namespace counterpoint::tools
{
std::string ProblemOfFileName(const std::string& text)
{
    return text.empty() ? "an empty name, expected the name of a file" : std::string();
}

std::string ProblemOfAddress(const std::string& text)
{
    return text.empty() ? "an empty address, expected a bus such as can0" : std::string();
}

std::string ProblemOfAnyText(const std::string& text)
{
    return text.empty() ? "an empty value, expected a text" : std::string();
}

bool Options::IsGiven(const std::string& name) const
{
    return std::any_of(options_.begin(), options_.end(),
                       [&name](const Option& option) { return option.name == name && option.times > 0U; });
}

std::size_t Options::GivenCount() const
{
    return static_cast<std::size_t>(
        std::count_if(options_.begin(), options_.end(), [](const Option& option) { return option.times > 0U; }));
}
} // namespace counterpoint::tools

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/protocols/replay.hpp"

#include <sstream>
#include <stdexcept>

namespace counterpoint::protocols
{
namespace
{

Numbers NumbersOf(const std::string& text)
{
    Numbers numbers;
    std::istringstream stream{text};
    for (std::int32_t number = 0; stream >> number;)
    {
        numbers.push_back(number);
    }
    if (!stream.eof())
    {
        throw std::runtime_error("no number in '" + text + "'");
    }
    return numbers;
}

} // namespace

std::string TextOf(const Numbers& numbers)
{
    std::string text;
    for (const std::int32_t number : numbers)
    {
        text += (text.empty() ? "" : " ") + std::to_string(number);
    }
    return text;
}

Model ReadModel(std::istream& lines)
{
    Model model{};
    std::set<std::string> known;
    for (std::string line; std::getline(lines, line);)
    {
        if ((line.rfind("T ", 0U) != 0U) || !known.insert(line).second)
        {
            continue;
        }
        std::istringstream stream{line.substr(2U)};
        std::vector<std::string> parts;
        for (std::string part; std::getline(stream, part, '|');)
        {
            parts.push_back(part);
        }
        if (parts.size() != 4U)
        {
            throw std::runtime_error("'" + line + "', expected 'T before | input | after | shown'");
        }
        const std::string before = TextOf(NumbersOf(parts[0]));
        model.first = (model.count == 0U) ? before : model.first;
        model.from[before].push_back(
            Transition{before, NumbersOf(parts[1]), TextOf(NumbersOf(parts[2])), NumbersOf(parts[3])});
        ++model.count;
    }
    if (model.count == 0U)
    {
        throw std::runtime_error("no transition, expected lines 'T before | input | after | shown'");
    }
    return model;
}

} // namespace counterpoint::protocols

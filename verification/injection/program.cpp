// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/program.hpp"

#include <fstream>
#include <stdexcept>

namespace counterpoint::injection
{

Program::Program(const std::string& binary, const std::string& description)
{
    std::ifstream bytes{binary, std::ios::binary};
    bytes.seekg(0, std::ios::end);
    code_.resize(bytes ? static_cast<std::size_t>(bytes.tellg()) : 0U);
    bytes.seekg(0);
    bytes.read(reinterpret_cast<char*>(code_.data()), static_cast<std::streamsize>(code_.size()));
    std::ifstream text{description};
    if (code_.empty() || (!text))
    {
        throw std::runtime_error{"cannot read " + binary + " or " + description};
    }
    is_faulted_.resize(code_.size());
    std::string kind;
    while (text >> kind)
    {
        std::string name;
        std::uint32_t first = 0U;
        std::uint32_t second = 0U;
        if (kind == "symbol")
        {
            text >> name >> first;
            symbols_[name] = first;
        }
        else
        {
            text >> first >> second;
            if (kind == "reads")
            {
                reads_[first] = second;
            }
            else if (kind == "memory")
            {
                memory_.push_back({first, second});
            }
            else
            {
                for (std::uint32_t address = first; (address < second) && (address < code_.size()); ++address)
                {
                    is_faulted_[address] = true;
                }
            }
        }
    }
}

std::uint32_t Program::Symbol(const std::string& name) const
{
    const auto found = symbols_.find(name);
    if (found == symbols_.end())
    {
        throw std::runtime_error{"the image has no symbol " + name};
    }
    return found->second;
}

std::uint32_t Program::Reads(const std::uint32_t address) const
{
    const auto found = reads_.find(address);
    return (found == reads_.end()) ? 0U : found->second;
}

} // namespace counterpoint::injection

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generated/numbers.hpp"

namespace counterpoint::generated
{
namespace
{

static_assert(sizeof(float) == sizeof(std::uint32_t), "REAL32");
static_assert(sizeof(double) == sizeof(std::uint64_t), "REAL64");

/// Byte by byte: the one way between a number and its pattern that needs no library and breaks no aliasing rule.
template <typename To, typename From> To Pattern(const From& from) noexcept
{
    static_assert(sizeof(To) == sizeof(From), "the same bytes");
    To to{};
    const unsigned char* const source = reinterpret_cast<const unsigned char*>(&from);
    unsigned char* const target = reinterpret_cast<unsigned char*>(&to);
    for (std::uint32_t i = 0U; i < sizeof(To); ++i)
    {
        target[i] = source[i];
    }
    return to;
}

} // namespace

std::int64_t ReadSigned(const VariablePlace& variable) noexcept
{
    const std::uint64_t sign = std::uint64_t{1U} << (variable.length_bits - 1U);
    const std::uint64_t bits = ReadVariable(variable).bits;
    return Pattern<std::int64_t>(static_cast<std::uint64_t>((bits ^ sign) - sign));
}

void WriteSigned(const VariablePlace& variable, const std::int64_t value) noexcept
{
    WriteVariable(variable, VariableValue{static_cast<std::uint64_t>(value)});
}

float ReadReal32(const VariablePlace& variable) noexcept
{
    return Pattern<float>(static_cast<std::uint32_t>(ReadVariable(variable).bits));
}

void WriteReal32(const VariablePlace& variable, const float value) noexcept
{
    WriteVariable(variable, VariableValue{Pattern<std::uint32_t>(value)});
}

double ReadReal64(const VariablePlace& variable) noexcept
{
    return Pattern<double>(ReadVariable(variable).bits);
}

void WriteReal64(const VariablePlace& variable, const double value) noexcept
{
    WriteVariable(variable, VariableValue{Pattern<std::uint64_t>(value)});
}

} // namespace counterpoint::generated

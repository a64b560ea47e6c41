// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/variables.hpp"

namespace counterpoint::third_voice
{
Variables::Variables(const DeviceConfig& config)
{
    for (std::size_t object = 0U; object < config.object_count; ++object)
    {
        values_[{config.objects[object].index, config.objects[object].sub}] = 0U;
    }
}

bool Variables::Has(const Address address) const
{
    return values_.count(address) != 0U;
}

std::uint64_t Variables::At(const Address address) const
{
    return values_.at(address);
}

void Variables::Put(const Address address, const std::uint64_t value)
{
    values_.at(address) = value;
}

std::uint64_t Variables::ReadNormal(const SrdoObjects& srdo) const
{
    return ReadSide(srdo, 0U);
}

std::uint64_t Variables::ReadInverse(const SrdoObjects& srdo) const
{
    return ReadSide(srdo, 1U);
}

std::uint64_t Variables::ReadSide(const SrdoObjects& srdo, const std::size_t side) const
{
    std::uint64_t data = 0U;
    std::uint32_t shift = 0U;
    for (std::size_t entry = side; entry < srdo.count; entry += 2U)
    {
        data |= values_.at(AddressOf(srdo.entries[entry])) << shift;
        shift += LengthOf(srdo.entries[entry]);
    }
    return data;
}

void Variables::Write(const SrdoObjects& srdo, const std::uint64_t normal)
{
    std::uint32_t shift = 0U;
    for (std::size_t entry = 0U; entry + 1U < srdo.count; entry += 2U)
    {
        const std::uint32_t bits = LengthOf(srdo.entries[entry]);
        const std::uint64_t value = (normal >> shift) & MaskOf(bits);
        values_[AddressOf(srdo.entries[entry])] = value;
        values_[AddressOf(srdo.entries[entry + 1U])] = ~value & MaskOf(bits);
        shift += bits;
    }
}
} // namespace counterpoint::third_voice

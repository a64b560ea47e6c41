// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/generate/random_device.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <array>

namespace counterpoint::generate::test
{
namespace
{
constexpr std::array<const char*, 20U> kNames{"Limits",
                                              "Map 1",
                                              "Signatures1",
                                              "Power on",
                                              "Speed",
                                              "Speed",
                                              "speed",
                                              "",
                                              "1st limit",
                                              "class",
                                              "Node ID",
                                              "Srdo1",
                                              "a*/b // c",
                                              "back\\slash\\",
                                              "what?\?/",
                                              "\xC4rger \xE4",
                                              "Value of the COB-ID of SRDOs",
                                              "+-%",
                                              "operator",
                                              "GetSpeed"};
constexpr std::array<const char*, 6U> kAccess{"ro", "rw", "wo", "const", "rwr", "rww"};
constexpr std::array<std::uint32_t, 30U> kTypes{0x01U, 0x02U, 0x03U, 0x04U, 0x05U, 0x06U, 0x07U, 0x08U, 0x09U, 0x0AU,
                                                0x0BU, 0x0CU, 0x0DU, 0x0FU, 0x10U, 0x11U, 0x12U, 0x13U, 0x14U, 0x15U,
                                                0x16U, 0x18U, 0x19U, 0x1AU, 0x1BU, 0x30U, 0x31U, 0x32U, 0x35U, 0x37U};

std::string TextValue(Random& random)
{
    std::string text;
    for (std::uint32_t left = random.Below(50U); left != 0U; --left)
    {
        text += static_cast<char>('0' + random.Below(60U));
    }
    return text;
}

/// Decimal limits around a decimal value.
std::string Limited(Random& random, const std::string& head, const std::string& name, const std::uint32_t type,
                    const std::string& access)
{
    const int value = static_cast<int>(random.Below(100U));
    const bool is_signed = type <= 0x04U;
    const int low = is_signed ? value - 20 : value / 2;
    return Section(head, name, type, access, std::to_string(value),
                   "LowLimit=" + std::to_string(low) + "\n" +
                       (random.OneIn(2U) ? "HighLimit=" + std::to_string(value + 7) + "\n" : ""));
}
} // namespace

std::string HexText(const std::uint64_t value, const int digits)
{
    return cia306::Hex(value, digits);
}

std::string Section(const std::string& head, const std::string& name, const std::uint32_t type,
                    const std::string& access, const std::string& value, const std::string& more)
{
    return "[" + head + "]\nParameterName=" + name + "\nObjectType=0x7\nDataType=" + HexText(type, 4) +
           "\nAccessType=" + access + "\nDefaultValue=" + value + "\nPDOMapping=0\n" + more + "\n";
}

std::string RandomObjects(Random& random)
{
    std::string text;
    for (std::uint32_t place = 0U; place < 60U; ++place)
    {
        const std::uint32_t type = place < kTypes.size() ? kTypes.at(place) : kTypes.at(random.Below(30U));
        const std::string head = HexText(0x6000U + place * 16U + random.Below(16U), 4).substr(2U);
        const std::string name = kNames.at(random.Below(16U));
        const std::string access = kAccess.at(random.Below(6U));
        const cia306::DataType& known = cia306::DataTypeOf(static_cast<std::uint16_t>(type));
        const bool is_integer = type >= 0x02U && type <= 0x07U;
        if (known.kind == cia306::DataKind::kText)
        {
            text += Section(head, name, type, access, TextValue(random));
        }
        else if (is_integer && random.OneIn(2U))
        {
            text += Limited(random, head, name, type, access);
        }
        else
        {
            const std::uint64_t value = random.Next() >> (64U - known.bits);
            text += Section(head, name, type, access, random.OneIn(5U) ? "" : HexText(value, 1));
        }
    }
    return text;
}
} // namespace counterpoint::generate::test

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_CHECKSUM_HPP
#define VERIFICATION_PROOF_CHECKSUM_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

// The step of a checksum against its definition. What holds for each state and each byte holds, by induction, for each
// message: docs/proof.md says how.
namespace counterpoint::proof
{

/// @brief CRC-16 as SRS_CFG_010 words it, bit by bit: polynomial 1021h, most significant bit first.
[[nodiscard]] std::uint16_t Divided16(std::uint16_t state, std::uint8_t byte);
/// @brief CRC-32 as SRS_CFG_034 words it, bit by bit: polynomial 04C11DB7h reflected, least significant bit first. The
/// state is what lies between start value and final complement.
[[nodiscard]] std::uint32_t Divided32(std::uint32_t state, std::uint8_t byte);

/// What a proof found.
struct Shown
{
    std::uint64_t steps{0U}; ///< So many were compared.
    std::string refused{};   ///< Why it does not hold; empty: it does.
};

/// @brief The text of one step that is not the definition's.
[[nodiscard]] std::string WrongStep(const char* name, std::uint32_t state, std::uint32_t byte, std::uint32_t found,
                                    std::uint32_t right);

/// An object that has taken in a message of two bytes stands in each of the 65536 states exactly once. From each of
/// them each of 256 bytes leads to the state that the definition gives, and to an object equal in every byte to the one
/// that stands there already: so there are no others, whatever the message. Crc16 has AddByte and Value.
template <typename Crc16> [[nodiscard]] Shown ProveSixteen()
{
    static_assert(std::is_trivially_copyable_v<Crc16>, "an object is its bytes");
    static_assert(std::has_unique_object_representations_v<Crc16>, "no byte of it is padding");
    constexpr std::uint32_t kStates = 65536U;
    constexpr std::uint32_t kBytes = 256U;
    Shown shown;
    std::vector<std::optional<Crc16>> standing(kStates);
    for (std::uint32_t message = 0U; message < kStates; ++message)
    {
        Crc16 crc{};
        crc.AddByte(message / kBytes);
        crc.AddByte(message % kBytes);
        standing[crc.Value()] = crc;
    }
    const Crc16 start{};
    for (std::uint32_t state = 0U; state < kStates; ++state)
    {
        if (!standing[state])
        {
            shown.refused = WrongStep("CRC-16, no message of two bytes leads there", state, 0U, 0U, 0U);
            return shown;
        }
    }
    if (std::memcmp(&start, &*standing[0U], sizeof(Crc16)) != 0)
    {
        shown.refused = WrongStep("CRC-16, start value", 0U, 0U, start.Value(), 0U);
        return shown;
    }
    for (std::uint32_t state = 0U; state < kStates; ++state)
    {
        for (std::uint32_t byte = 0U; byte < kBytes; ++byte)
        {
            Crc16 crc{*standing[state]};
            crc.AddByte(byte);
            const std::uint16_t right = Divided16(static_cast<std::uint16_t>(state), static_cast<std::uint8_t>(byte));
            ++shown.steps;
            if (std::memcmp(&crc, &*standing[right], sizeof(Crc16)) != 0)
            {
                shown.refused = WrongStep("CRC-16", state, byte, crc.Value(), right);
                return shown;
            }
        }
    }
    return shown;
}

/// One step of the register of a Crc32: it begins with the complement of what it is given, and tells the complement of
/// where it stands.
template <typename Crc32> [[nodiscard]] std::uint32_t Stepped32(const std::uint32_t state, const std::uint8_t byte)
{
    Crc32 crc{~state};
    crc.AddByte(byte);
    return ~crc.Value();
}

/// Each byte of the state at each place beside each byte of input, and each two bytes of the state beside each other:
/// from these a step that is linear over XOR is known whole, and the linearity is shown as far as two bytes reach. Then
/// `draws` states with a byte each, from a fixed seed: of a step that is linear nowhere they would leave nothing.
template <typename Crc32> [[nodiscard]] Shown ProveThirtyTwo(const std::uint32_t draws)
{
    static_assert(std::has_unique_object_representations_v<Crc32>, "no byte of it is padding");
    static_assert(sizeof(Crc32) == sizeof(std::uint32_t), "the register is all there is");
    constexpr std::uint32_t kBytes = 256U;
    Shown shown;
    const auto compare = [&shown](const std::uint32_t state, const std::uint32_t byte)
    {
        const std::uint8_t input = static_cast<std::uint8_t>(byte);
        const std::uint32_t found = Stepped32<Crc32>(state, input);
        const std::uint32_t right = Divided32(state, input);
        ++shown.steps;
        if ((found != right) && shown.refused.empty())
        {
            shown.refused = WrongStep("CRC-32", state, byte, found, right);
        }
    };
    for (std::uint32_t first = 0U; first < kBytes; ++first)
    {
        for (std::uint32_t second = 0U; second < kBytes; ++second)
        {
            for (std::uint32_t place = 0U; place < 32U; place += 8U)
            {
                compare(first << place, second);
                for (std::uint32_t other = place + 8U; other < 32U; other += 8U)
                {
                    compare((first << place) | (second << other), 0U);
                }
            }
        }
    }
    std::uint64_t drawn = 1U;
    for (std::uint32_t draw = 0U; draw < draws; ++draw)
    {
        drawn = (drawn * 6364136223846793005U) + 1442695040888963407U;
        compare(static_cast<std::uint32_t>(drawn >> 32U), static_cast<std::uint32_t>(drawn >> 24U) & 0xFFU);
    }
    return shown;
}

/// All 2^32 states, each with the byte 0 and with one that depends on the state.
template <typename Crc32> [[nodiscard]] Shown ProveEachState()
{
    Shown shown;
    std::uint32_t state = 0U;
    do
    {
        const std::uint8_t byte = static_cast<std::uint8_t>((state * 0x9E3779B1U) >> 24U);
        const std::uint32_t found = Stepped32<Crc32>(state, byte);
        const std::uint32_t empty = Stepped32<Crc32>(state, 0U);
        const std::uint32_t right = Divided32(state, byte);
        const std::uint32_t right_empty = Divided32(state, 0U);
        shown.steps += 2U;
        if ((found != right) || (empty != right_empty))
        {
            shown.refused = WrongStep("CRC-32", state, (found != right) ? byte : 0U, (found != right) ? found : empty,
                                      (found != right) ? right : right_empty);
            return shown;
        }
        ++state;
    } while (state != 0U);
    return shown;
}

} // namespace counterpoint::proof

#endif

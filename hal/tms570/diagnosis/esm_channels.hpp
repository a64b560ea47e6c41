// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_DIAGNOSIS_ESM_CHANNELS_HPP
#define HAL_TMS570_DIAGNOSIS_ESM_CHANNELS_HPP

#include <cstdint>

/// All 128 channels of the error signalling module with what they stand for and what becomes of them. One table for the
/// family: a channel that a variant does not have never speaks, and if it does, the device becomes safe. Source:
/// facts/tms570 4; data sheets, table "ESM channel assignments". [SRS_TMS_030]
namespace counterpoint::tms570
{

enum class EsmReaction : std::uint8_t
{
    kInvalid = 0U,          ///< Read as kSafeState.
    kRecord = 1U,           ///< Corrected by the hardware: counted, and safe state when it comes again and again.
    kSafeState = 0x5AU,     ///< Outputs off, nERROR low, in the interrupt.
    kHardwareState = 0x3CU, ///< As kSafeState; nERROR by the hardware alone, and the processor sees an abort.
};

/// One channel: what it stands for, and what becomes of its errors.
struct EsmChannelEntry
{
    const char* name;
    EsmReaction reaction;
};

inline constexpr std::uint32_t kEsmGroup1Channels = 64U;
inline constexpr std::uint32_t kEsmGroup2Channels = 32U;
inline constexpr std::uint32_t kEsmGroup3Channels = 32U;
inline constexpr const char* kEsmReserved = "reserved";

inline constexpr EsmChannelEntry kEsmGroup1[] = {
    // MISRA D-001
    {kEsmReserved, EsmReaction::kSafeState},                         // 0
    {"ADC 2 parity", EsmReaction::kSafeState},                       // 1
    {"DMA memory protection", EsmReaction::kSafeState},              // 2
    {"DMA parity or ECC", EsmReaction::kSafeState},                  // 3
    {kEsmReserved, EsmReaction::kSafeState},                         // 4
    {"DMA or trace imprecise read", EsmReaction::kSafeState},        // 5
    {"flash corrected", EsmReaction::kRecord},                       // 6
    {"timer 1 or 2 parity", EsmReaction::kSafeState},                // 7
    {"timer transfer parity", EsmReaction::kSafeState},              // 8
    {"timer transfer memory protection", EsmReaction::kSafeState},   // 9
    {"PLL slip", EsmReaction::kSafeState},                           // 10
    {"clock monitor", EsmReaction::kSafeState},                      // 11
    {"FlexRay parity", EsmReaction::kSafeState},                     // 12
    {"DMA or trace imprecise write", EsmReaction::kSafeState},       // 13
    {"FlexRay transfer parity", EsmReaction::kSafeState},            // 14
    {"VIM parity or ECC", EsmReaction::kSafeState},                  // 15
    {"FlexRay transfer memory protection", EsmReaction::kSafeState}, // 16
    {"SPI 1 parity", EsmReaction::kSafeState},                       // 17
    {"SPI 3 parity", EsmReaction::kSafeState},                       // 18
    {"ADC 1 parity", EsmReaction::kSafeState},                       // 19
    {kEsmReserved, EsmReaction::kSafeState},                         // 20
    {"DCAN 1 parity", EsmReaction::kSafeState},                      // 21
    {"DCAN 3 parity", EsmReaction::kSafeState},                      // 22
    {"DCAN 2 parity", EsmReaction::kSafeState},                      // 23
    {"SPI 5 parity", EsmReaction::kSafeState},                       // 24
    {kEsmReserved, EsmReaction::kSafeState},                         // 25
    {"RAM even bank corrected", EsmReaction::kRecord},               // 26
    {"LBIST failed", EsmReaction::kSafeState},                       // 27
    {"RAM odd bank corrected", EsmReaction::kRecord},                // 28
    {kEsmReserved, EsmReaction::kSafeState},                         // 29
    {"DCC 1", EsmReaction::kSafeState},                              // 30
    {"lockstep self test", EsmReaction::kSafeState},                 // 31
    {kEsmReserved, EsmReaction::kSafeState},                         // 32
    {kEsmReserved, EsmReaction::kSafeState},                         // 33
    {kEsmReserved, EsmReaction::kSafeState},                         // 34
    {"data flash corrected", EsmReaction::kRecord},                  // 35
    {"data flash uncorrectable", EsmReaction::kSafeState},           // 36
    {"pin multiplexing", EsmReaction::kSafeState},                   // 37
    {"power domain compare", EsmReaction::kSafeState},               // 38
    {"power domain self test", EsmReaction::kSafeState},             // 39
    {"eFuse", EsmReaction::kSafeState},                              // 40
    {"eFuse self test", EsmReaction::kSafeState},                    // 41
    {"PLL 2 slip", EsmReaction::kSafeState},                         // 42
    {"Ethernet master interface", EsmReaction::kSafeState},          // 43
    {kEsmReserved, EsmReaction::kSafeState},                         // 44
    {kEsmReserved, EsmReaction::kSafeState},                         // 45
    {kEsmReserved, EsmReaction::kSafeState},                         // 46
    {kEsmReserved, EsmReaction::kSafeState},                         // 47
    {kEsmReserved, EsmReaction::kSafeState},                         // 48
    {kEsmReserved, EsmReaction::kSafeState},                         // 49
    {kEsmReserved, EsmReaction::kSafeState},                         // 50
    {"DCAN 4 parity", EsmReaction::kSafeState},                      // 51
    {kEsmReserved, EsmReaction::kSafeState},                         // 52
    {kEsmReserved, EsmReaction::kSafeState},                         // 53
    {kEsmReserved, EsmReaction::kSafeState},                         // 54
    {kEsmReserved, EsmReaction::kSafeState},                         // 55
    {kEsmReserved, EsmReaction::kSafeState},                         // 56
    {kEsmReserved, EsmReaction::kSafeState},                         // 57
    {kEsmReserved, EsmReaction::kSafeState},                         // 58
    {kEsmReserved, EsmReaction::kSafeState},                         // 59
    {kEsmReserved, EsmReaction::kSafeState},                         // 60
    {kEsmReserved, EsmReaction::kSafeState},                         // 61
    {"DCC 2", EsmReaction::kSafeState},                              // 62
    {kEsmReserved, EsmReaction::kSafeState},                         // 63
};

inline constexpr EsmChannelEntry kEsmGroup2[] = {
    // MISRA D-001
    {kEsmReserved, EsmReaction::kSafeState},                                   // 0
    {kEsmReserved, EsmReaction::kSafeState},                                   // 1
    {"lockstep compare", EsmReaction::kSafeState},                             // 2
    {"processor bus (LC43x)", EsmReaction::kSafeState},                        // 3
    {"flash uncorrectable (address)", EsmReaction::kSafeState},                // 4
    {kEsmReserved, EsmReaction::kSafeState},                                   // 5
    {"RAM even bank uncorrectable", EsmReaction::kSafeState},                  // 6
    {"level 2 RAM (LC43x)", EsmReaction::kSafeState},                          // 7
    {"RAM odd bank uncorrectable", EsmReaction::kSafeState},                   // 8
    {kEsmReserved, EsmReaction::kSafeState},                                   // 9
    {"RAM even bank address parity", EsmReaction::kSafeState},                 // 10
    {kEsmReserved, EsmReaction::kSafeState},                                   // 11
    {"RAM odd bank address parity", EsmReaction::kSafeState},                  // 12
    {kEsmReserved, EsmReaction::kSafeState},                                   // 13
    {kEsmReserved, EsmReaction::kSafeState},                                   // 14
    {kEsmReserved, EsmReaction::kSafeState},                                   // 15
    {"flash ECC live-lock", EsmReaction::kSafeState},                          // 16
    {"level 2 flash parity (LC43x)", EsmReaction::kSafeState},                 // 17
    {kEsmReserved, EsmReaction::kSafeState},                                   // 18
    {"level 2 flash settings uncorrectable (LC43x)", EsmReaction::kSafeState}, // 19
    {kEsmReserved, EsmReaction::kSafeState},                                   // 20
    {"processor ECC (LC43x)", EsmReaction::kSafeState},                        // 21
    {kEsmReserved, EsmReaction::kSafeState},                                   // 22
    {kEsmReserved, EsmReaction::kSafeState},                                   // 23
    {"windowed watchdog", EsmReaction::kSafeState},                            // 24
    {"VIM lockstep compare (LC43x)", EsmReaction::kSafeState},                 // 25
    {"bus of the idle processor (LC43x)", EsmReaction::kSafeState},            // 26
    {kEsmReserved, EsmReaction::kSafeState},                                   // 27
    {"power domain that is off (LC43x)", EsmReaction::kSafeState},             // 28
    {kEsmReserved, EsmReaction::kSafeState},                                   // 29
    {kEsmReserved, EsmReaction::kSafeState},                                   // 30
    {kEsmReserved, EsmReaction::kSafeState},                                   // 31
};

inline constexpr EsmChannelEntry kEsmGroup3[] = {
    // MISRA D-001
    {kEsmReserved, EsmReaction::kHardwareState},                  // 0
    {"eFuse autoload", EsmReaction::kHardwareState},              // 1
    {kEsmReserved, EsmReaction::kHardwareState},                  // 2
    {"RAM even bank uncorrectable", EsmReaction::kHardwareState}, // 3
    {kEsmReserved, EsmReaction::kHardwareState},                  // 4
    {"RAM odd bank uncorrectable", EsmReaction::kHardwareState},  // 5
    {kEsmReserved, EsmReaction::kHardwareState},                  // 6
    {"flash uncorrectable", EsmReaction::kHardwareState},         // 7
    {kEsmReserved, EsmReaction::kHardwareState},                  // 8
    {kEsmReserved, EsmReaction::kHardwareState},                  // 9
    {kEsmReserved, EsmReaction::kHardwareState},                  // 10
    {kEsmReserved, EsmReaction::kHardwareState},                  // 11
    {kEsmReserved, EsmReaction::kHardwareState},                  // 12
    {kEsmReserved, EsmReaction::kHardwareState},                  // 13
    {kEsmReserved, EsmReaction::kHardwareState},                  // 14
    {kEsmReserved, EsmReaction::kHardwareState},                  // 15
    {kEsmReserved, EsmReaction::kHardwareState},                  // 16
    {kEsmReserved, EsmReaction::kHardwareState},                  // 17
    {kEsmReserved, EsmReaction::kHardwareState},                  // 18
    {kEsmReserved, EsmReaction::kHardwareState},                  // 19
    {kEsmReserved, EsmReaction::kHardwareState},                  // 20
    {kEsmReserved, EsmReaction::kHardwareState},                  // 21
    {kEsmReserved, EsmReaction::kHardwareState},                  // 22
    {kEsmReserved, EsmReaction::kHardwareState},                  // 23
    {kEsmReserved, EsmReaction::kHardwareState},                  // 24
    {kEsmReserved, EsmReaction::kHardwareState},                  // 25
    {kEsmReserved, EsmReaction::kHardwareState},                  // 26
    {kEsmReserved, EsmReaction::kHardwareState},                  // 27
    {kEsmReserved, EsmReaction::kHardwareState},                  // 28
    {kEsmReserved, EsmReaction::kHardwareState},                  // 29
    {kEsmReserved, EsmReaction::kHardwareState},                  // 30
    {kEsmReserved, EsmReaction::kHardwareState},                  // 31
};

static_assert(sizeof kEsmGroup1 / sizeof kEsmGroup1[0] == kEsmGroup1Channels, "one row a channel");
static_assert(sizeof kEsmGroup2 / sizeof kEsmGroup2[0] == kEsmGroup2Channels, "one row a channel");
static_assert(sizeof kEsmGroup3 / sizeof kEsmGroup3[0] == kEsmGroup3Channels, "one row a channel");

/// @brief Channels of a half of group 1 (first 0 or 32) that are only recorded.
[[nodiscard]] constexpr std::uint32_t RecordedChannels(const std::uint32_t first) noexcept
{
    std::uint32_t mask = 0U;
    for (std::uint32_t bit = 0U; bit < 32U; ++bit)
    {
        mask |= (kEsmGroup1[first + bit].reaction == EsmReaction::kRecord) ? (1U << bit) : 0U;
    }
    return mask;
}

/// Channels that drivers ask for by name.
inline constexpr std::uint32_t kEsmFlashCorrected = 1U << 6U;
inline constexpr std::uint32_t kEsmVimTable = 1U << 15U;
/// Of channels 64 to 95, which no driver sets up: 83.
inline constexpr std::uint32_t kEsmVimOneBit = 1U << 19U;
inline constexpr std::uint32_t kEsmEvenRamCorrected = 1U << 26U;
inline constexpr std::uint32_t kEsmOddRamCorrected = 1U << 28U;
inline constexpr std::uint32_t kEsmClockComparator = 1U << 30U;
inline constexpr std::uint32_t kEsmLockstepSelfTest = 1U << 31U;
inline constexpr std::uint32_t kEsm2Lockstep = 1U << 2U;
inline constexpr std::uint32_t kEsm2EvenRam = 1U << 6U;
inline constexpr std::uint32_t kEsm2Level2Ram = 1U << 7U;
inline constexpr std::uint32_t kEsm2OddRam = 1U << 8U;
inline constexpr std::uint32_t kEsm2VimLockstep = 1U << 25U;
inline constexpr std::uint32_t kEsm2IdleBus = 1U << 26U;
inline constexpr std::uint32_t kEsm2PowerDomain = 1U << 28U;
inline constexpr std::uint32_t kEsm3EvenRam = 1U << 3U;
inline constexpr std::uint32_t kEsm3OddRam = 1U << 5U;
inline constexpr std::uint32_t kEsm3Flash = 1U << 7U;

} // namespace counterpoint::tms570

#endif

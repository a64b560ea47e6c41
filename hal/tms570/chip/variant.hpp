// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_CHIP_VARIANT_HPP
#define HAL_TMS570_CHIP_VARIANT_HPP

#include "hal/tms570/chip/registers.hpp"

#include <cstdint>

/// What differs between the controllers of the family, as constants: a driver is handed the table of its controller and
/// has no other way to know. Sources: facts/tms570 1 to 4 (register headers of the vendor's safety library and code
/// generator, data sheets SPNS141, SPNS192, SPNS162, SPNS195). [SRS_TMS_002]
namespace counterpoint::tms570
{

enum class Presence : std::uint8_t
{
    kInvalid = 0U, ///< Read as absent.
    kAbsent = 1U,
    kPresent = 0x69U,
};

/// How the VIM protects its table of vectors.
enum class TableCheck : std::uint8_t
{
    kInvalid = 0U, ///< The test of the table fails.
    kParity = 1U,  ///< One bit a word.
    kEcc = 0x69U,  ///< Seven bits a word: one wrong bit and two are told apart.
};

/// Bits of MSINENA and of the memory groups of the PBIST that a device with two CAN controllers uses.
struct MemorySelection
{
    std::uint32_t initialise;  ///< MSINENA: memories whose parity is turned on later (VIM, DCAN 1 and 2).
    std::uint32_t test_rom;    ///< PBIST memory group of the ROMs of PBIST and STC.
    std::uint32_t test_memory; ///< PBIST memory groups of the same memories as `initialise`.
};

/// PLL 1 multiplies the oscillator: 16 MHz / NR * NF / 2, with NR in bits 21:16 and 256 * NF in bits 15:0 of its first
/// register, each less its unit. RTICLK and VCLK are half of the processor's clock.
struct ClockTree
{
    std::uint32_t pll_control_1;
    std::uint32_t pll_control_2;
    std::uint8_t oscillator_mhz;
    std::uint8_t processor_mhz; ///< GCLK, and HCLK.
    std::uint8_t rti_mhz;       ///< RTICLK; VCLK is the same.
};

/// Registers of clocks and power that are checked to the last bit and do not have the same bits everywhere.
struct SystemSetup
{
    std::uint32_t flash_read;  ///< FRDCNTL: 3 wait states; pipeline, or prefetch of both ports.
    std::uint32_t sources_off; ///< CSDIS: external clocks and the second PLL.
    std::uint32_t rti_source;  ///< RCLKSRC: VCLK.
    RegisterBase power[3];     ///< Controllers of the peripherals' power; address 0: none. // MISRA D-001
};

/// One controller of the family.
struct Variant
{
    RegisterBase dcan[2]; // MISRA D-001
    std::uint8_t can_objects;
    std::uint8_t mpu_regions;
    Presence clock_comparator; ///< DCC1.
    Presence tcram_test;       ///< RAM on the B-TCM with the ECC test of the TCRAM module.
    Presence level_2_ram;      ///< RAM behind the L2RAMW module with its diagnosis.
    Presence flash_diagnosis;  ///< Flash wrapper with diagnostic mode 7.
    Presence windowed_watchdog;
    TableCheck table_check;
    std::uint8_t comparators; ///< Of the CCM, from the first: processors, VIMs, idle processor's bus, power domains.
    std::uint32_t flash_bytes;
    std::uint32_t ram_bytes;
    ClockTree clocks;
    SystemSetup system;
    MemorySelection memories;
};

inline constexpr std::uint32_t kRamOrigin = 0x08000000U;
inline constexpr RegisterBase kDcan1Base{0xFFF7DC00U};
inline constexpr RegisterBase kDcan2Base{0xFFF7DE00U};

inline constexpr SystemSetup kCortexR4System{0x311U, 0xC8U, 0x01090109U, {{0xFFFFE000U}, {0U}, {0U}}};

inline constexpr Variant kLs20x{
    {kDcan1Base, kDcan2Base},
    64U,
    12U,
    Presence::kAbsent,
    Presence::kPresent,
    Presence::kAbsent,
    Presence::kPresent,
    Presence::kAbsent,
    TableCheck::kParity,
    1U,
    0x00200000U,
    0x00028000U,
    ClockTree{0x20056800U, 0x3FC0723DU, 16U, 140U, 70U},
    kCortexR4System,
    MemorySelection{0x00000064U, 0x00000001U, 0x0000020CU},
};

inline constexpr Variant kLs12x{
    {kDcan1Base, kDcan2Base},
    64U,
    12U,
    Presence::kPresent,
    Presence::kPresent,
    Presence::kAbsent,
    Presence::kPresent,
    Presence::kPresent,
    TableCheck::kParity,
    1U,
    0x00140000U,
    0x00030000U,
    ClockTree{0x20057700U, 0x3FC0723DU, 16U, 160U, 80U},
    kCortexR4System,
    MemorySelection{0x00000064U, 0x00000003U, 0x0000020CU},
};

inline constexpr Variant kLs31x{
    {kDcan1Base, kDcan2Base},
    64U,
    12U,
    Presence::kPresent,
    Presence::kPresent,
    Presence::kAbsent,
    Presence::kPresent,
    Presence::kPresent,
    TableCheck::kParity,
    1U,
    0x00300000U,
    0x00040000U,
    ClockTree{0x20057700U, 0x3FC0723DU, 16U, 160U, 80U},
    kCortexR4System,
    MemorySelection{0x00000064U, 0x00000003U, 0x0000020CU},
};

/// Memories: SPNS195C, tables 6-33 (groups of the PBIST: DCAN1 6, DCAN2 7, VIM 14, ROMs 1 to 3) and 6-34 (MSINENA).
/// Table of the VIM: SPNU563A, 19.5; comparators: 13.2; clocks: 2.5.1.10 (bit 2 of CSDIS reads 1), 2.5.1.18, 7.10.1;
/// power: as the vendor's code generator has it.
inline constexpr Variant kLc43x{
    {kDcan1Base, kDcan2Base},
    64U,
    16U,
    Presence::kPresent,
    Presence::kAbsent,
    Presence::kPresent,
    Presence::kAbsent,
    Presence::kPresent,
    TableCheck::kEcc,
    4U,
    0x00400000U,
    0x00080000U,
    ClockTree{0x20079500U, 0x3FC0723DU, 16U, 150U, 75U},
    SystemSetup{0x303U, 0xCCU, 0x109U, {{0xFFFF1000U}, {0xFCFF1000U}, {0xFFF78000U}}},
    MemorySelection{0x00000064U, 0x00000007U, 0x00002060U},
};

} // namespace counterpoint::tms570

#endif

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_DEFECTIVE_MEMORY_HPP
#define HAL_HOST_DEFECTIVE_MEMORY_HPP

#include "hal/api/memory_access.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::host
{

/// One bit of the memory.
struct Cell
{
    hal::Address place;
    std::uint8_t bit;
};

/// Kinds of defects of functional RAM tests. The victim is the cell that is wrong, the aggressor the one that makes it
/// so.
enum class CellDefect : std::uint8_t
{
    kNone = 0U,
    kStuckAtZero = 1U,
    kStuckAtOne = 2U,
    kNoRise = 3U,           ///< The victim cannot go from 0 to 1.
    kNoFall = 4U,           ///< The victim cannot go from 1 to 0.
    kInvertsOnRise = 5U,    ///< The aggressor's rise inverts the victim.
    kInvertsOnFall = 6U,    ///< The aggressor's fall inverts the victim.
    kSetsOnRise = 7U,       ///< The aggressor's rise makes the victim 1.
    kSetsOnFall = 8U,       ///< The aggressor's fall makes the victim 1.
    kClearsOnRise = 9U,     ///< The aggressor's rise makes the victim 0.
    kClearsOnFall = 10U,    ///< The aggressor's fall makes the victim 0.
    kZeroWhileZero = 11U,   ///< The victim is 0 while the aggressor is 0.
    kZeroWhileOne = 12U,    ///< The victim is 0 while the aggressor is 1.
    kOneWhileZero = 13U,    ///< The victim is 1 while the aggressor is 0.
    kOneWhileOne = 14U,     ///< The victim is 1 while the aggressor is 1.
    kLineStuckAtZero = 15U, ///< The address line 2^bit of the victim always selects 0.
    kLineStuckAtOne = 16U,
    kNoCell = 17U,   ///< The victim's word does not exist: writes are lost, reads give all ones.
    kAlias = 18U,    ///< The victim's word is that of the aggressor.
    kTwoCells = 19U, ///< A write to the victim's word also goes to the aggressor's; a read is the AND of both.
};

/// A kind of defect and the cells that it concerns.
struct Defect
{
    CellDefect kind;
    Cell victim;
    Cell aggressor;
};

/// Passes accesses on to other memory and puts one defect into them, so that live memory can be tested as defective.
/// Only accesses through this object see the defect. [SRS_STS_010, SRS_STS_015]
class DefectiveMemory final : public hal::MemoryAccess
{
  public:
    /// @brief Without a defect at first; `cells` outlives this.
    explicit DefectiveMemory(hal::MemoryAccess& cells);

    /// @brief From now on there is this defect, and no other one.
    void Break(const Defect& defect);
    [[nodiscard]] std::uint32_t Read(hal::Address place) const noexcept override;
    void Write(hal::Address place, std::uint32_t value) noexcept override;
    [[nodiscard]] std::uint32_t Exchange(hal::Address place, std::uint32_t value) noexcept override;
    [[nodiscard]] hal::Address StackPosition() const noexcept override;
    [[nodiscard]] hal::Address PlaceOf(const void* object) const noexcept override;
    /// @brief Accesses so far, an exchange counting as two.
    [[nodiscard]] std::uint64_t Accesses() const;

  private:
    [[nodiscard]] hal::Address Decode(hal::Address place) const;
    [[nodiscard]] std::uint32_t WithVictim(std::uint32_t value, std::uint32_t victim_bit) const;
    [[nodiscard]] std::uint32_t AsStored(std::uint32_t before, std::uint32_t value) const;
    void Disturb(hal::Address place, std::uint32_t before, std::uint32_t after);
    void HoldState();

    hal::MemoryAccess& cells_;
    Defect defect_{CellDefect::kNone, {0U, 0U}, {0U, 0U}};
    mutable std::uint64_t accesses_{0U};
};

/// Memory in an array, with addresses of its own from `first` on, for tests that choose their addresses.
class ArrayMemory final : public hal::MemoryAccess
{
  public:
    /// @brief All words are 0.
    ArrayMemory(hal::Address first, std::uint32_t words);

    [[nodiscard]] std::uint32_t Read(hal::Address place) const noexcept override;
    void Write(hal::Address place, std::uint32_t value) noexcept override;
    [[nodiscard]] std::uint32_t Exchange(hal::Address place, std::uint32_t value) noexcept override;
    /// @brief 0: far from every place of the array.
    [[nodiscard]] hal::Address StackPosition() const noexcept override;
    [[nodiscard]] hal::Address PlaceOf(const void* object) const noexcept override;

  private:
    [[nodiscard]] std::size_t IndexOf(hal::Address place) const;

    hal::Address first_;
    std::vector<std::uint32_t> words_;
};

} // namespace counterpoint::host

#endif

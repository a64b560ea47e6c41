// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/defective_memory.hpp"

namespace counterpoint::host
{

namespace
{

constexpr std::uint32_t kNothingThere = 0xFFFFFFFFU;

[[nodiscard]] std::uint32_t BitOf(const Cell& cell)
{
    return std::uint32_t{1U} << cell.bit;
}

/// What a coupling defect waits for and what it does to the victim.
struct Coupling
{
    bool acts_on_rise;
    bool acts_on_fall;
    bool inverts;
    bool sets; ///< Else clears.
};

[[nodiscard]] Coupling CouplingOf(const CellDefect kind)
{
    const bool on_rise = (kind == CellDefect::kInvertsOnRise) || (kind == CellDefect::kSetsOnRise) ||
                         (kind == CellDefect::kClearsOnRise);
    const bool on_fall = (kind == CellDefect::kInvertsOnFall) || (kind == CellDefect::kSetsOnFall) ||
                         (kind == CellDefect::kClearsOnFall);
    const bool inverts = (kind == CellDefect::kInvertsOnRise) || (kind == CellDefect::kInvertsOnFall);
    const bool sets = (kind == CellDefect::kSetsOnRise) || (kind == CellDefect::kSetsOnFall);
    return Coupling{on_rise, on_fall, inverts, sets};
}

} // namespace

DefectiveMemory::DefectiveMemory(hal::MemoryAccess& cells) : cells_(cells)
{
}

void DefectiveMemory::Break(const Defect& defect)
{
    defect_ = defect;
    HoldState();
}

std::uint64_t DefectiveMemory::Accesses() const
{
    return accesses_;
}

hal::Address DefectiveMemory::StackPosition() const noexcept
{
    return cells_.StackPosition();
}

hal::Address DefectiveMemory::PlaceOf(const void* const object) const noexcept
{
    return cells_.PlaceOf(object);
}

hal::Address DefectiveMemory::Decode(const hal::Address place) const
{
    const hal::Address line = hal::Address{1U} << defect_.victim.bit;
    if (defect_.kind == CellDefect::kLineStuckAtZero)
    {
        return place & ~line;
    }
    if (defect_.kind == CellDefect::kLineStuckAtOne)
    {
        return place | line;
    }
    const bool is_alias = (defect_.kind == CellDefect::kAlias) && (place == defect_.victim.place);
    return is_alias ? defect_.aggressor.place : place;
}

std::uint32_t DefectiveMemory::WithVictim(const std::uint32_t value, const std::uint32_t victim_bit) const
{
    return (victim_bit != 0U) ? (value | BitOf(defect_.victim)) : (value & ~BitOf(defect_.victim));
}

/// What the victim's word holds after a write of `value`, as far as the victim alone decides.
std::uint32_t DefectiveMemory::AsStored(const std::uint32_t before, const std::uint32_t value) const
{
    const std::uint32_t bit = BitOf(defect_.victim);
    if (defect_.kind == CellDefect::kStuckAtZero)
    {
        return value & ~bit;
    }
    if (defect_.kind == CellDefect::kStuckAtOne)
    {
        return value | bit;
    }
    if (defect_.kind == CellDefect::kNoRise)
    {
        return WithVictim(value, value & before & bit);
    }
    return (defect_.kind == CellDefect::kNoFall) ? WithVictim(value, (value | before) & bit) : value;
}

/// What a change of the aggressor does to the victim.
void DefectiveMemory::Disturb(const hal::Address place, const std::uint32_t before, const std::uint32_t after)
{
    const std::uint32_t bit = BitOf(defect_.aggressor);
    const bool changed = (place == defect_.aggressor.place) && (((before ^ after) & bit) != 0U);
    const Coupling coupling = CouplingOf(defect_.kind);
    const bool acts = ((after & bit) != 0U) ? coupling.acts_on_rise : coupling.acts_on_fall;
    if (!changed || !acts)
    {
        return;
    }
    const std::uint32_t victim = cells_.Read(defect_.victim.place);
    const std::uint32_t inverted = victim ^ BitOf(defect_.victim);
    cells_.Write(defect_.victim.place, coupling.inverts ? inverted : WithVictim(victim, coupling.sets ? 1U : 0U));
}

/// Defects that hold at every moment.
void DefectiveMemory::HoldState()
{
    const bool is_state = (defect_.kind >= CellDefect::kZeroWhileZero) && (defect_.kind <= CellDefect::kOneWhileOne);
    const bool is_stuck = (defect_.kind == CellDefect::kStuckAtZero) || (defect_.kind == CellDefect::kStuckAtOne);
    if (is_stuck)
    {
        const std::uint32_t victim = cells_.Read(defect_.victim.place);
        cells_.Write(defect_.victim.place, AsStored(victim, victim));
    }
    if (!is_state)
    {
        return;
    }
    const bool is_one = (cells_.Read(defect_.aggressor.place) & BitOf(defect_.aggressor)) != 0U;
    const bool while_one = (defect_.kind == CellDefect::kZeroWhileOne) || (defect_.kind == CellDefect::kOneWhileOne);
    const bool gives_one = (defect_.kind == CellDefect::kOneWhileZero) || (defect_.kind == CellDefect::kOneWhileOne);
    if (is_one == while_one)
    {
        const std::uint32_t victim = cells_.Read(defect_.victim.place);
        cells_.Write(defect_.victim.place, WithVictim(victim, gives_one ? 1U : 0U));
    }
}

std::uint32_t DefectiveMemory::Read(const hal::Address place) const noexcept
{
    ++accesses_;
    const bool is_victim = place == defect_.victim.place;
    if (is_victim && (defect_.kind == CellDefect::kNoCell))
    {
        return kNothingThere;
    }
    const std::uint32_t value = cells_.Read(Decode(place));
    const bool is_double = is_victim && (defect_.kind == CellDefect::kTwoCells);
    return is_double ? (value & cells_.Read(defect_.aggressor.place)) : value;
}

void DefectiveMemory::Write(const hal::Address place, const std::uint32_t value) noexcept
{
    ++accesses_;
    const bool is_victim = place == defect_.victim.place;
    if (is_victim && (defect_.kind == CellDefect::kNoCell))
    {
        return;
    }
    const hal::Address chosen = Decode(place);
    const std::uint32_t before = cells_.Read(chosen);
    cells_.Write(chosen, is_victim ? AsStored(before, value) : value);
    if (is_victim && (defect_.kind == CellDefect::kTwoCells))
    {
        cells_.Write(defect_.aggressor.place, value);
    }
    Disturb(place, before, value);
    HoldState();
}

std::uint32_t DefectiveMemory::Exchange(const hal::Address place, const std::uint32_t value) noexcept
{
    const std::uint32_t before = Read(place);
    Write(place, value);
    return before;
}

ArrayMemory::ArrayMemory(const hal::Address first, const std::uint32_t words) : first_(first), words_(words)
{
}

std::size_t ArrayMemory::IndexOf(const hal::Address place) const
{
    return (place - first_) / hal::kWordBytes;
}

std::uint32_t ArrayMemory::Read(const hal::Address place) const noexcept
{
    return words_.at(IndexOf(place));
}

void ArrayMemory::Write(const hal::Address place, const std::uint32_t value) noexcept
{
    words_.at(IndexOf(place)) = value;
}

std::uint32_t ArrayMemory::Exchange(const hal::Address place, const std::uint32_t value) noexcept
{
    const std::uint32_t before = Read(place);
    Write(place, value);
    return before;
}

hal::Address ArrayMemory::StackPosition() const noexcept
{
    return 0U;
}

hal::Address ArrayMemory::PlaceOf(const void* /*object*/) const noexcept
{
    return 0U;
}

} // namespace counterpoint::host

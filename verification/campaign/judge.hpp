// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_JUDGE_HPP
#define VERIFICATION_CAMPAIGN_JUDGE_HPP

#include "verification/campaign/bus_view.hpp"
#include "verification/campaign/device.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpoint::campaign
{
/// What must never happen without being noticed. [SRS_CMG_005]
enum class Wrong : std::uint8_t
{
    kNothing = 0U,
    kData = 1U,       ///< Open, with data that the bus did not bring, or too old.
    kNoLeave = 2U,    ///< Open outside of OPERATIONAL, or before the first acknowledge.
    kRestart = 3U,    ///< Open again without an acknowledge; open or sending behind a device fault.
    kIdentifier = 4U, ///< A frame under an identifier that is not the device's.
    kSentPair = 5U,   ///< A complete valid pair on the bus with data that the application did not have.
    kOldPair = 6U,    ///< The same with data that the application had longer ago than its form allows. [SRS_CMG_812]
};

/// What the judge remembers from cycle to cycle. Plain memory.
struct JudgeMemory
{
    SrdoMask armed{0U};   ///< An acknowledge came since OPERATIONAL was entered, or since an error closed the output.
    SrdoMask erred{0U};   ///< An error was told, and nothing has been taken back since.
    SrdoMask stopped{0U}; ///< An error took the released pair back, and no acknowledge has come since.
    SrdoMask told{0U};    ///< Of Told::faulted.
    SrdoMask opened{0U};  ///< Open in the cycle before.
    SrdoMask closed{0U};  ///< Closed since it was open, whoever told of it, and no acknowledge has come since.
    SrdoMask left{0U};    ///< Armed in the cycle before, and no longer: a stop or a GFC came.
    SrdoMask pressed{0U};
    std::uint32_t fault_cycles{0U}; ///< Cycles since a device fault was told.
    std::uint32_t safe_cycles{0U};  ///< Since the kernel itself says that there is one.
    std::uint32_t sent{0U};
    std::array<OwnFrame, kMaxSrdoCount>
        normal{}; ///< The last normal frame of each producer that waits for its inverse.
    std::array<std::int64_t, kMaxSrdoCount> pair_at{};
    std::array<Received, kMaxSrdoCount> received{};
    std::size_t looked{0U}; ///< Cycles whose frames were taken.
    bool has_gfc{false};    ///< One of them was a GFC.
};

/// What the judge saw in a cycle.
struct Sight
{
    Wrong wrong{Wrong::kNothing};
    SrdoMask open{0U};
    SrdoMask listed{0U};      ///< Open by a complete valid pair that nobody sent, or that is too old: the listed limit.
    SrdoMask not_inverse{0U}; ///< Open, but the pair of variables does not pass the application's check.
    bool is_missed{false};    ///< Who consumes what the device sends has waited longer than SCT.
    bool is_bad_frame{false}; ///< A frame was sent that nobody can use, or with data that the application did not have.
    bool is_overdue{false};   ///< No pair was complete within refresh time and a cycle as late as it may be.

    bool operator==(const Sight& other) const noexcept
    {
        return wrong == other.wrong && open == other.open && listed == other.listed &&
               not_inverse == other.not_inverse && is_missed == other.is_missed && is_bad_frame == other.is_bad_frame &&
               is_overdue == other.is_overdue;
    }
};

/// Decides from bus, inputs and output alone what the device may do: neither the kernel's nor the channels' opinion is
/// asked, but for the errors that the application is told of. [SRS_CMG_005]
class Judge
{
  public:
    /// @brief All outlive it.
    Judge(const Recording& recording, const runtime::DeviceModel& model, Device& device);

    /// @brief After each cycle.
    [[nodiscard]] Sight Look(std::size_t cycle, JudgeMemory& memory);

  private:
    /// An SRDO of the device.
    struct Srdo
    {
        SlotIndex slot{kNoSlot};
        std::uint8_t number{0U};
        bool is_consumer{false};
        bool is_automatic{false};
        std::size_t input_cycles{0U}; ///< An input that changed so many cycles ago may still be sent as it was.
        runtime::SrdoModel model{};
        std::uint32_t bits{0U};
        std::uint64_t safe{0U};     ///< Of a consumer.
        std::vector<BusView> bus{}; ///< One of a consumer.
        std::vector<FlatPair> pairs{};
    };

    void Arm(std::size_t cycle, SrdoMask open, JudgeMemory& memory) const;
    [[nodiscard]] static bool IsTakenBack(const Srdo& srdo);
    void NoteClosed(const Srdo& srdo, SrdoMask open, SrdoMask edge, JudgeMemory& memory) const;
    void TakeFrames(std::size_t cycle, JudgeMemory& memory) const;
    [[nodiscard]] static bool MayStillClose(const Srdo& srdo, const JudgeMemory& memory);
    void LookAtOutput(const Srdo& srdo, std::size_t cycle, const JudgeMemory& memory, Sight& sight) const;
    void LookAtFrames(std::size_t cycle, JudgeMemory& memory, Sight& sight) const;
    void LookAtPairs(std::size_t cycle, JudgeMemory& memory, Sight& sight) const;
    [[nodiscard]] Wrong LookAtFrame(const OwnFrame& own, std::size_t cycle, JudgeMemory& memory, Sight& sight) const;
    [[nodiscard]] std::size_t InputCyclesOf(const Srdo& srdo) const;
    [[nodiscard]] Wrong JudgePair(const Srdo& srdo, std::uint64_t data, std::size_t cycle) const;
    [[nodiscard]] bool WereInputs(const Srdo& srdo, std::uint64_t data, std::size_t cycle, std::size_t cycles) const;
    [[nodiscard]] bool WasInput(const FlatPair& pair, std::uint64_t value, std::size_t cycle, std::size_t cycles) const;

    const Recording& recording_;
    Device& device_;
    std::vector<Srdo> srdos_{};
    bool knows_gfc_;          ///< 1300h is 1.
    Nanoseconds slack_;       ///< Of what comes in time: a cycle as late as it may be, both frames of a pair.
    Nanoseconds discrepancy_; ///< For which the pair before may still be in place.
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_JUDGE_HPP

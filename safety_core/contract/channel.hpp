// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CONTRACT_CHANNEL_HPP
#define SAFETY_CORE_CONTRACT_CHANNEL_HPP

#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/configuration.hpp"
#include "safety_core/contract/srdo.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint
{

/// NMT state as the kernel and the channels know it. SRDOs work in kOperational alone; every value that is not listed
/// counts as another state.
enum class NmtState : std::uint8_t
{
    kInvalid = 0U,
    kInitialising = 0x11U,
    kPreOperational = 0x22U,
    kStopped = 0x44U,
    kOperational = 0xD8U,
};

/// Whether all frames of the bus reached the kernel since the previous cycle.
enum class QueueState : std::uint8_t
{
    kInvalid = 0U, ///< Read as an overflow.
    kIntact = 0x66U,
    kOverflowed = 1U,
};

/// What a channel thinks of the guard's token of this cycle. [SRS_CFG_031]
enum class GuardView : std::uint8_t
{
    kInvalid = 0U,
    kConfigured = 0xA5U,   ///< Token fits the challenge and this channel's own 13FEh, which is A5h.
    kUnconfigured = 0x0FU, ///< Token fits the challenge and this channel's own 13FEh, which is not A5h.
    kStale = 0x30U,        ///< Token does not fit: guard not called, or another 13FEh than this channel's.
};

/// Parties of the three permits, each with a constant of its own. The answer to a challenge is
///     ((challenge + mask bits 0 to 31) XOR (mask bits 32 to 63 rotated left by 16)) * constant   (modulo 2^32).
///     [SRS_REL_010]
constexpr std::uint32_t kPermitConstantA = 0x9E3779B1U;
constexpr std::uint32_t kPermitConstantB = 0x85EBCA77U;
constexpr std::uint32_t kPermitConstantKernel = 0xC2B2AE3DU;

/// CRC-32 over the safety parameters that the signature 13FFh does not cover. [SRS_CFG_034]
struct DeviceDigest
{
    std::uint32_t value;
};

/// Permission of one party for the outputs of the slots in `mask`. A response of 0 never fits.
struct Permit
{
    SrdoMask mask;
    std::uint32_t response;
};

/// What the comparator found about the consumers. A slot that is agreed but not matched keeps the pair written before.
struct Agreement
{
    SrdoMask agreed;  ///< Released by both channels.
    SrdoMask matched; ///< The held pairs of both channels have the same ordinal and equal data.
};

/// `guard_token` is (challenge rotated left by 8) XOR (13FEh in each of the four bytes). [SRS_CFG_031]
struct CycleInput
{
    Instant now;
    std::uint32_t challenge; ///< Changes every cycle, never 0.
    std::uint32_t guard_token;
    SrdoMask acknowledge; ///< What the acknowledge input of each slot reads in this cycle. [SRS_REL_005]
    SrdoMask request; ///< Producers that the application wants to send; asked since the previous cycle. [SRS_PROD_003]
    SrdoMask stand;   ///< Producers whose refresh phase stood still since the previous cycle. [SRS_PROD_012]
    NmtState nmt;
    QueueState queue; ///< Whether a frame was lost since the previous cycle.
};

/// What the comparator looks at every cycle: bit n is slot n. Bit-identical across channels for the same inputs.
struct CycleOutcome
{
    SrdoMask released;         ///< Consumers in state kReleased.
    SrdoMask faulted;          ///< Consumers in state kFaulted.
    SrdoMask waiting;          ///< Consumers in state kWaiting.
    SrdoMask new_fault;        ///< Consumers for which this call reports a fault that occurred since the previous call.
    SrdoMask fresh;            ///< Consumers that hold a pair completed since the previous call.
    SrdoMask due;              ///< Producers for which Prepare is to be called now. [SRS_PROD_004]
    SrdoMask refresh;          ///< Producers whose refresh fell due and was not prepared yet. [SRS_PROD_013]
    SrdoMask signalled;        ///< Slots with something in SrdoView::signals.
    std::uint32_t cycle;       ///< Number of OnCycle calls since Restart, modular; the first returns 1.
    std::uint32_t ordinal_sum; ///< Sum of the ordinals of all active consumers, modular.
    GuardView guard;
    std::uint8_t sct_checked;     ///< Consumers whose limits were examined in this call.
    std::uint8_t is_tx;           ///< Producers passed over by that examination.
    std::uint8_t is_invalid;      ///< SRDOs passed over because they are off (direction 0).
    std::uint8_t not_operational; ///< 1 when nothing was examined (not OPERATIONAL, or configuration not valid); then
                                  ///< the others are 0.
};

/// What the comparator needs of a consumer to match its pair: two words of a 64-bit processor, four of a 32-bit one.
/// [SRS_CONS_025]
struct HeldPair
{
    Payload data;             ///< As in SrdoView; 0 unless `holds_pair`.
    std::uint32_t ordinal;    ///< As in SrdoView.
    std::uint32_t holds_pair; ///< 1: a complete valid pair is held and no limit has expired; else 0.
};

/// Details of one slot, for diagnosis.
struct SrdoView
{
    Payload data;              ///< Normal data of the held pair (consumer) or of the pair being sent (producer).
    std::uint32_t ordinal;     ///< Consumer: pairs completed since the last fault or since OPERATIONAL was entered.
                               ///< Producer: pairs sent.
    std::uint32_t signals;     ///< Bit (1 << cause): reported by the most recent OnCycle. [SRS_CONS_021]
    std::uint16_t error_count; ///< Faults since Restart, the first one included; stays at 65535.
    SrdoState state;
    SrdoCause first_cause;
    std::uint8_t holds_pair; ///< 1: a complete valid pair is held and no limit has expired; else 0.
};

/// Whether a channel prepared a pair.
enum class PrepareStatus : std::uint8_t
{
    kInvalid = 0U,
    kReady = 0x69U,
    kNotProducer = 2U, ///< Not an idle producer in OPERATIONAL.
};

/// What one channel wants to have on the bus. Each reads its own side, and both give the complete normal frame: where
/// they are equal every bit of the inversion holds, and identifier, controller and length were found twice. All of
/// `normal` is 0 unless `status` is kReady; bytes behind its length are 0.
struct PreparedPair
{
    CanFrame
        normal; ///< Channel A: from what the normal objects hold. Channel B: from the complement of the inverse ones.
    PrepareStatus status;
};

/// What the confirmation of a frame meant to a channel. [SRS_PROD_007]
enum class ConfirmStep : std::uint8_t
{
    kNone = 0U,      ///< Not a frame in flight, or one that ended the pair with a fault.
    kNormal = 0x55U, ///< The normal frame of the pair in flight.
    kPair = 0xAAU,   ///< The inverse frame: the pair was sent.
};

/// What a channel made of a confirmation, and for which slot; `slot` is kNoSlot with kNone.
struct Confirmation
{
    SlotIndex slot;
    ConfirmStep step;
};

/// Why a transmission failed. A structure, because the compilers of the two channels do not agree on who clears the
/// upper bits of an enumeration that is passed by itself.
struct TransmitFault
{
    SrdoCause cause;
};

/// One voice. Two diverse implementations: channel_a, channel_b. Not reentrant; keeps no reference to its arguments
/// except to the DeviceConfig of Restart. Every `slot` is below srdo_count, checked by the kernel. No call allocates,
/// blocks or loops without bound. What each call does, step by step, is in docs/requirements/channel.sdoc.
class Channel
{
  public:
    /// @brief Power-on state: copies what it needs of the setups; defaults of the configuration as SRS_CFG_002; 13FEh
    /// 0, everything off. `config` outlives the channel's use. O(srdo_count)
    virtual void Restart(const DeviceConfig& config) noexcept = 0;

    /// @brief Keeps one value, admitted by the guard, which alone calls this. O(1) [SRS_CFG_003]
    virtual void Store(const ConfigItem& item) noexcept = 0;
    /// @brief The value kept at `address`; 0 for an address that does not exist. O(1)
    [[nodiscard]] virtual ConfigItem Load(const ConfigAddress& address) const noexcept = 0;

    /// @brief What this channel's storage has room for, for the kernel to refuse a device that is too large. O(1)
    [[nodiscard]] virtual ChannelRoom Room() const noexcept = 0;
    /// @brief Registers the fields of an SRDO with a static mapping; makes its mapping unresolved. No effect on an SRDO
    /// with a dynamic one. O(1) [SRS_CFG_032]
    virtual void SetFields(SlotIndex slot, const StaticFields& fields) noexcept = 0;
    /// @brief CRC-32 over what the signature does not cover, continued from `before`: the device's part before slot 0,
    /// then the slot's part. 0 starts. O(1) [SRS_CFG_034]
    [[nodiscard]] virtual DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept = 0;

    /// @brief All rules of one SRDO, in order, then its signature; resolves the mapping and writes the safe value into
    /// the objects this channel owns if there is no fault. Not in OPERATIONAL. O(entries * log objects)
    /// [SRS_CFG_020, SRS_CFG_021, SRS_CFG_022, SRS_CFG_023, SRS_CFG_024, SRS_CFG_025, SRS_CFG_026, SRS_CFG_027,
    /// SRS_CFG_028, SRS_CFG_029, SRS_CFG_037]
    [[nodiscard]] virtual CheckResult Validate(SlotIndex slot) noexcept = 0;
    /// @brief Signature and resolved mapping of one SRDO again; in every state. O(entries) [SRS_CFG_030]
    [[nodiscard]] virtual CheckResult Recheck(SlotIndex slot) noexcept = 0;

    /// @brief Takes one raw frame in bus order; what is not ours is ignored. O(payload) [SRS_CONS_001, SRS_CONS_002,
    /// SRS_CONS_003, SRS_CONS_004, SRS_CONS_005, SRS_CONS_006, SRS_CONS_007, SRS_CONS_008, SRS_CONS_009, SRS_CONS_010,
    /// SRS_CONS_011, SRS_CONS_012, SRS_CONS_013, SRS_CONS_014, SRS_CONS_015, SRS_CONS_016, SRS_CONS_017, SRS_CONS_018,
    /// SRS_CONS_019]
    virtual void OnFrame(const CanFrame& frame, Instant stamp) noexcept = 0;
    /// @brief Limits, acknowledge, NMT, refresh; once a kernel cycle, after all its frames. O(srdo_count) Realises the
    /// consumer, release and producer of docs/requirements/channel.sdoc.
    [[nodiscard]] virtual CycleOutcome OnCycle(const CycleInput& input) noexcept = 0;
    /// @brief The held pair of an active consumer; all 0 for every other slot. O(1) [SRS_CONS_025]
    [[nodiscard]] virtual HeldPair Held(SlotIndex slot) const noexcept = 0;
    /// @brief The details of one slot, for diagnosis and for the application. O(1) [SRS_CONS_025]
    [[nodiscard]] virtual SrdoView View(SlotIndex slot) const noexcept = 0;
    /// @brief The other channel reported a fault for this consumer: be safe too. No effect unless the slot is a
    /// consumer in kWaiting, kFaulted or kReleased. [SRS_REL_006]
    virtual void Demote(SlotIndex slot) noexcept = 0;
    /// @brief Writes the objects this channel owns (A the normal, B the inverse ones): the held pair where it is
    /// agreed, matched and released by this channel too, the safe value where a slot is no longer agreed. Then reads
    /// back what it wrote, and the slots in `examine`, which it wrote before. The slots of which an object holds
    /// something else. O(changed + examined) [SRS_REL_002, SRS_REL_011]
    [[nodiscard]] virtual SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept = 0;
    /// @brief This channel's permit for the slots that the last Commit, since the last OnCycle, left released and found
    /// as they were written. O(1) [SRS_REL_010]
    [[nodiscard]] virtual Permit Answer(std::uint32_t challenge) const noexcept = 0;

    /// @brief Reads the objects of its own side (A the normal, B the inverse ones); uses up what made the slot due. A
    /// pair that is kReady is in flight from the `now` of the last OnCycle. O(entries) [SRS_PROD_005, SRS_PROD_006]
    [[nodiscard]] virtual PreparedPair Prepare(SlotIndex slot) noexcept = 0;
    /// @brief A frame of this device was on the bus. O(payload) [SRS_PROD_007]
    [[nodiscard]] virtual Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept = 0;
    /// @brief The inverse frame of a pair whose normal frame was confirmed, until the pair is over: A the complement of
    /// what it read, B what it read. Kind kInvalid and all members 0 if there is none. O(payload) [SRS_PROD_006]
    [[nodiscard]] virtual CanFrame InverseFrame(SlotIndex slot) const noexcept = 0;
    /// @brief The transmission of this slot failed (kTransmitQueue, kBusOff), the two sides are not inverse
    /// (kNotInverse), or the other channel found the confirmation late (kNoConfirmation): the cause is recorded and the
    /// pair is given up. O(1) [SRS_PROD_009]
    virtual void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept = 0;

    Channel(const Channel&) = delete;
    Channel(Channel&&) = delete;
    Channel& operator=(const Channel&) = delete;
    Channel& operator=(Channel&&) = delete;

  protected:
    Channel() noexcept = default;
    ~Channel() noexcept = default; // Non-virtual: nothing is deleted through it, and no operator delete is linked.
};

} // namespace counterpoint

#endif

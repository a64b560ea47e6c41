// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_FLIP_RIG_HPP
#define VERIFICATION_CONFORMANCE_FLIP_RIG_HPP

#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
#include "safety_core/comparator/comparator.hpp"
#include "verification/conformance/device.hpp"
#include "verification/conformance/dictionary.hpp"
#include "verification/conformance/step.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

/// Both channels of a small device with the comparator, for flipping bits in a channel's storage from outside. Host
/// only.
namespace counterpoint::conformance
{

constexpr std::uint8_t kRigSlots = 3U; ///< Consumer gold, producer of two bytes, one that is off.

/// What a run with a flipped bit did wrong; empty if nothing.
using Complaint = std::string;

/// What the two SRDOs are.
enum class RigKind : std::uint8_t
{
    kBytes, ///< Dynamic mappings of bytes, early detection.
    kFixed, ///< Static mappings of bytes, late detection.
    kBits,  ///< Dynamic mappings of 3 bits, a dummy and 12 bits; of 4 and 12 bits to send.
};

/// One object of each side, and the place of its bits in the data.
struct RigObject
{
    std::uint16_t normal_index;
    std::uint16_t inverse_index;
    std::uint8_t sub;
    std::uint8_t shift;
    std::uint16_t mask; ///< Of its bits.
};

/// Device of a kind. `values` and `objects` are those of the consumer and of the producer.
struct RigDevice
{
    SrdoValues values[2];
    RigObject consumed[2];
    RigObject sent[2];
    StaticMap maps[2];
    SrvtDetection detection;
};

/// By RigKind.
extern const RigDevice kRigDevices[];
/// @brief Bits of the data that objects of the consumer hold.
[[nodiscard]] std::uint32_t MappedBits(const RigDevice& device);

class FlipRig
{
  public:
    explicit FlipRig(ReleasePolicy policy, RigKind device_kind = RigKind::kBytes);

    /// @brief Power-on and the whole configuration; NMT state PRE-OPERATIONAL.
    void Start();
    void Enter();
    void Leave();
    /// @brief Both channels, comparator, Commit, permits; whatever is granted is looked at.
    void Cycle(std::uint32_t elapsed_us);
    void Acknowledge(bool level);
    /// @brief A valid pair, its second half only if `is_whole`.
    void Pair(std::uint32_t data, bool is_whole);
    void InverseOf(std::uint32_t data);
    void WrongPair(std::uint32_t data);
    /// @brief With the next cycle.
    void Request();
    /// @brief Prepare of the producer by both channels, if the comparator lets it start.
    void Prepare();
    /// @brief Confirms the normal frame that A prepared.
    void SendNormal();
    /// @brief Takes the inverse frame that both have to send, without sending it.
    void TakeInverse();
    /// @brief Confirms the inverse frame that was taken before, or that both have to send.
    void SendInverse();
    void Recheck();
    /// @brief A wrong signature in both channels, and found by both.
    void SpoilSignature();

    [[nodiscard]] Channel& Of(Party party);
    [[nodiscard]] SrdoState StateOf(Party party) const;
    /// @brief Bytes of the storage of one channel, flipped from outside.
    [[nodiscard]] std::uint8_t* Bytes(Party party);
    [[nodiscard]] static std::size_t ByteCount(Party party);
    [[nodiscard]] const Complaint& Complaints() const;
    [[nodiscard]] bool IsGranted() const;

  private:
    /// Bytes beside a storage, which nobody writes.
    struct Fence
    {
        std::uint8_t bytes[32]{};
    };

    void Store(SlotIndex slot, ConfigField field, std::uint8_t sub, std::uint32_t value);
    [[nodiscard]] std::uint32_t ReadSide(bool is_inverse) const;
    void CompareDigests();
    [[nodiscard]] bool IsLegitimate(std::uint32_t granted) const;
    void LookAtOutputs(const Permit& a, const Permit& b);
    [[nodiscard]] bool IsFenced() const;
    void Feed(std::uint32_t identifier, std::uint32_t data);
    void Confirm(const CanFrame& frame);

    const RigDevice& device_;
    SrdoSetup setups_[kRigSlots]{};
    DeviceConfig config_{};
    Dictionary dictionary_{};
    Fence before_a_{};
    channel_a::StorageFor<kRigSlots> storage_a_{};
    Fence behind_a_{};
    channel_b::StorageFor<kRigSlots> storage_b_{};
    Fence behind_b_{};
    channel_a::Channel a_;
    channel_b::Channel b_;
    Comparator comparator_{};
    Verdict verdict_{};
    Complaint complaint_{};
    NmtState nmt_{NmtState::kPreOperational};
    std::uint32_t clock_us_{0U};
    std::uint32_t challenge_{1U};
    std::uint32_t cycles_{0U};
    /// A valid pair on the bus, by the moment of its normal frame.
    struct Sent
    {
        std::uint32_t data;
        std::uint32_t normal_us;
        bool is_valid;
    };

    Sent last_{0U, 0U, false};
    Sent before_{0U, 0U, false}; ///< The pair before: it stays in place while a newer one is not matched.
    std::uint32_t pending_us_{0U};
    std::uint32_t sent_normal_{0U};
    SrdoMask acknowledge_{0U};
    SrdoMask request_{0U};
    CanFrame normal_{};  ///< Prepared, not on the bus yet; kind kInvalid if there is none.
    CanFrame inverse_{}; ///< Taken, not on the bus yet.
    bool has_sent_normal_{false};
    bool is_device_safe_{false};
    bool is_granted_{false};
};

/// Phases of operation in which a bit is flipped.
constexpr std::uint32_t kPhaseCount = 14U;

/// What was found over all bits of the storage of `party` in one phase: the complaints, and how many runs granted
/// something after the flip (so that a rig that grants nothing does not pass as safe).
struct FlipResult
{
    std::uint32_t runs;
    std::uint32_t granted;
    std::uint32_t complaints;
    Complaint first;
};

/// @brief Flips every single bit of the storage of `party`, and sets every byte to 00h and to FFh, one run each.
[[nodiscard]] FlipResult FlipEveryBit(Party party, ReleasePolicy policy, std::uint32_t phase,
                                      RigKind device_kind = RigKind::kBytes);
/// @brief Flips every single bit of the storage of a configured channel, then stores the signature that Recheck
/// computes: a mapping entry that is not the one validated must be found by the table. `granted` counts those that
/// were.
[[nodiscard]] FlipResult FlipSignedEntries(Party party, RigKind device_kind);
/// @brief The whole storage of `party` becomes `fill` in the given phase.
[[nodiscard]] FlipResult FillStorage(Party party, ReleasePolicy policy, std::uint32_t phase, std::uint8_t fill,
                                     RigKind device_kind = RigKind::kBytes);

} // namespace counterpoint::conformance

#endif

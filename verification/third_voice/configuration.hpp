// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_CONFIGURATION_HPP
#define VERIFICATION_THIRD_VOICE_CONFIGURATION_HPP

#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/configuration.hpp"
#include "safety_core/kernel/object_access.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace counterpoint::third_voice
{
using Address = std::pair<std::uint16_t, std::uint8_t>;

/// The objects of one SRDO as a client on the bus sees them.
struct SrdoObjects
{
    std::uint32_t direction{0U};
    std::uint32_t sct_ms{0U};
    std::uint32_t srvt_ms{0U};
    std::uint32_t transmission_type{254U};
    std::uint32_t cob_id_1{0U};
    std::uint32_t cob_id_2{0U};
    std::uint32_t count{0U};
    std::vector<std::uint32_t> entries; ///< As many as the device has room for.
    std::uint32_t signature{0U};
};

/// CRC of 13FFh, bit by bit. [semantics 7]
[[nodiscard]] std::uint16_t SignatureOf(const SrdoObjects& srdo);

/// One rule that is broken on purpose: a comparison that does not see it shows nothing. [SRS_VER_032]
enum class Flaw : std::uint8_t
{
    kNone = 0U,
    kSctLonger,       ///< SCT is one microsecond longer.
    kSrvtLonger,      ///< SRVT is.
    kNoInversion,     ///< The inverse frame is not compared.
    kNoSignature,     ///< 13FFh is not.
    kKeepsReleased,   ///< Leaving OPERATIONAL writes no safe value.
    kEdgeAtOnce,      ///< One reading of the acknowledge is a level.
    kOneEdgeIsEnough, ///< The acknowledge of one channel releases.
    kToldAlways,      ///< A cause has no window.
    kRefreshDrifts,   ///< Each refresh comes a microsecond later.
    kSharedObjects,   ///< Two consumers may map one object.
    kRefreshSkipped,  ///< A refresh that finds a pair on its way is skipped.
    kRequestAlone,    ///< A request does not wait for the refresh of the other channel.
    kNothingStands,   ///< The counter that is ahead does not wait.
    kHalfConfirmed,   ///< What was confirmed too late for one channel alone stays on its way in the other.
    kBehindFault,     ///< A pair behind a fault that is not told yet starts SCT.
    kMissesStanding,  ///< A refresh that stands is examined.
    kLateIsInTime,    ///< A request that comes in the call that finds it late is in time.
    kSilenceShorter,  ///< Silence of an application has a cycle's grace without its tolerance.
    kSilenceLonger,   ///< It is a microsecond longer.
    kGfcPutOff,       ///< A GFC that is sent again begins its time anew.
    kGfcAtOnce,       ///< It is over in the first cycle.
    kGfcFromCycle,    ///< Behind a start the time of a GFC begins with the first cycle, not one cycle time before.
    kMissedInLevel2,  ///< In level 2 a refresh is missed.
    kEntersInLevel2,  ///< It is where OPERATIONAL was entered in level 2.
    kSentInLevel2,    ///< In level 2 the inverse frame follows its normal frame.
    kKeepsInLevel2,   ///< In level 2 the objects keep what was released.
    kGfcFollowed,     ///< A frame that the controller did not take follows a GFC.
};

/// What a mapping entry says.
[[nodiscard]] std::uint32_t LengthOf(std::uint32_t entry);
[[nodiscard]] Address AddressOf(std::uint32_t entry);
/// Of all normal entries together.
[[nodiscard]] std::uint32_t BitsOf(const SrdoObjects& srdo);
/// That many bits, from the lowest on.
[[nodiscard]] std::uint64_t MaskOf(std::uint32_t bits);

/// The answer to a write.
struct Written
{
    AbortCode abort{AbortCode::kNone};
    std::vector<std::size_t> safe; ///< Consumers that get their safe values: sound ones, also where a later one makes
                                   ///< the whole refused.
};

/// 1300h to 13FFh with their abort codes: what may be written, and whether it is sound. [semantics 7]
class Configuration
{
  public:
    /// @brief `config` outlives it.
    Configuration(const DeviceConfig& config, Flaw flaw);

    void SetInitial(std::size_t slot, const SrdoObjects& objects);
    void SetGfcParameter(std::uint32_t value);
    void Start();
    [[nodiscard]] Written Write(Address address, std::uint32_t value, std::size_t size, NmtState nmt);

    [[nodiscard]] std::optional<std::size_t> SlotOf(std::uint32_t number) const;
    [[nodiscard]] bool IsGfcOn() const;
    [[nodiscard]] bool IsValid() const;
    [[nodiscard]] bool IsAllSound() const;
    /// @brief The lowest slot that is not sound.
    [[nodiscard]] std::optional<std::size_t> FirstFaulty() const;
    [[nodiscard]] const SrdoObjects& Objects(std::size_t slot) const;

  private:
    [[nodiscard]] Written WriteSingle(Address address, std::uint32_t value, std::size_t size, bool is_operational);
    [[nodiscard]] Written WriteValid(std::uint32_t value);
    [[nodiscard]] static AbortCode CheckParameter(std::uint8_t sub, std::size_t size);
    [[nodiscard]] AbortCode CheckMapping(std::uint8_t sub, std::size_t size) const;
    [[nodiscard]] AbortCode WriteSignature(std::uint8_t sub, std::uint32_t value, std::size_t size,
                                           bool is_operational);
    [[nodiscard]] AbortCode WriteParameter(SrdoObjects& objects, std::uint8_t sub, std::uint32_t value);
    [[nodiscard]] AbortCode WriteIdentifier(SrdoObjects& objects, std::uint8_t sub, std::uint32_t value);
    [[nodiscard]] AbortCode WriteMapping(SrdoObjects& objects, std::uint8_t sub, std::uint32_t value);
    [[nodiscard]] AbortCode CheckIdentifier(const SrdoObjects& objects) const;
    [[nodiscard]] bool IsSound(const SrdoObjects& objects) const;
    [[nodiscard]] bool IsMappingSound(const SrdoObjects& objects) const;
    [[nodiscard]] const MappableObject* ObjectOf(std::uint32_t entry) const;
    void Keep(std::uint32_t& place, std::uint32_t value);

    const DeviceConfig& config_;
    Flaw flaw_;
    std::vector<SrdoObjects> srdos_; ///< By slot.
    std::uint32_t gfc_parameter_{0U};
    std::uint32_t valid_{0U};
};
} // namespace counterpoint::third_voice

#endif

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The safety pins of the TMS570 as they once were, in the place of the shipped ones: which pins are safety outputs is
// one word, `used_`, that nothing protects. A bit of it that is lost leaves its pin high. The campaign has to find it.
#include "hal/tms570/output/gio_registers.hpp"
#include "verification/campaign/pins_output.hpp"

#include <cstddef>

namespace counterpoint::campaign
{
namespace
{
using namespace tms570::gio;
using tms570::At;
using tms570::Bits;
using tms570::Looks;
using tms570::Outcome;
using tms570::Read;
using tms570::Write;

constexpr Looks kPinLooks{64U};
constexpr std::uint32_t kLive = 0x5A5A5A5AU;

class UnprotectedPins
{
  public:
    explicit UnprotectedPins(hal::Clocks& clocks) noexcept : clocks_(clocks)
    {
    }

    [[nodiscard]] Outcome Start(const tms570::SafetyPinsSetup& setup) noexcept
    {
        setup_ = setup;
        for (std::uint32_t pin = 0U; pin < kPins; ++pin)
        {
            used_ |= (setup.pins[pin].slots != 0U) ? (1U << pin) : 0U;
        }
        Write(At(setup.port, kClear), used_);
        Write(At(setup.port, kDirection), used_);
        live_ = kLive;
        return Outcome::kDone;
    }
    [[nodiscard]] std::uint32_t Challenge() noexcept
    {
        return gate_.Challenge();
    }
    void Drive(const hal::PermitSet& permits) noexcept
    {
        const Instant now = clocks_.Now().a;
        gate_.Drive(permits, now);
        SetPins(gate_.Open(now, setup_.limit));
    }
    [[nodiscard]] Outcome Examine() noexcept
    {
        if (live_ != kLive)
        {
            return Outcome::kFailed;
        }
        SetPins(gate_.Open(clocks_.Now().a, setup_.limit));
        const bool are_outputs = (Read(At(setup_.port, kDirection)) & used_) == used_;
        if (!are_outputs ||
            (tms570::WaitFor(At(setup_.port, kInput), Bits{used_, driven_}, kPinLooks) != Outcome::kDone))
        {
            CutOff();
            return Outcome::kFailed;
        }
        return Outcome::kDone;
    }

    tms570::SafetyPinsSetup setup_{};
    std::uint32_t used_{0U}; ///< The defect.
    std::uint32_t driven_{0U};

  private:
    void CutOff() noexcept
    {
        live_ = 0U;
        Write(At(setup_.port, kClear), used_);
        Write(At(setup_.port, kDirection), Read(At(setup_.port, kDirection)) & ~used_);
    }
    void SetPins(const SrdoMask open) noexcept
    {
        driven_ = 0U;
        for (std::uint32_t pin = 0U; pin < kPins; ++pin)
        {
            const SrdoMask slots = setup_.pins[pin].slots;
            driven_ |= ((slots != 0U) && ((open & slots) == slots)) ? (1U << pin) : 0U;
        }
        Write(At(setup_.port, kClear), used_ & ~driven_);
        Write(At(setup_.port, kSet), driven_);
    }

    hal::Clocks& clocks_;
    hal::OutputGate gate_{};
    std::uint32_t live_{0U};
};

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
constexpr PinsMember kMembers[] = {{"pins.used", offsetof(UnprotectedPins, used_), sizeof(std::uint32_t)}};
#pragma GCC diagnostic pop
} // namespace

FlatOutput& MakePinsOutput(Region& region, const DeviceConfig& config, std::vector<Place>& places)
{
    return MakePins<UnprotectedPins>(region, config, kMembers, places);
}
} // namespace counterpoint::campaign

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_DCAN_MODEL_HPP
#define VERIFICATION_MODELS_TMS570_DCAN_MODEL_HPP

#include "safety_core/contract/can_frame.hpp"
#include "verification/models/tms570/esm_model.hpp"
#include "verification/models/tms570/peripheral.hpp"

#include <optional>

namespace counterpoint::tms570::model
{

/// DCAN: 64 message objects behind two interfaces, acceptance, lost messages, interrupts, bus-off, parity.
class DcanModel final : public Peripheral
{
  public:
    /// @brief parity_channel: of group 1 of the ESM.
    DcanModel(const FaultSet& faults, EsmModel& esm, std::uint32_t parity_channel);

    /// @brief A frame of another node ends on the bus now. False: nobody listens.
    bool Receive(const CanFrame& frame);
    /// @brief The frame with the lowest identifier that waits ends on the bus now.
    [[nodiscard]] std::optional<CanFrame> Transmit();
    /// @brief Too many errors: off the bus, Init set by the hardware.
    void GoBusOff();
    /// @brief 128 times 11 recessive bits have passed.
    void Recover();
    [[nodiscard]] bool Line();
    [[nodiscard]] bool IsOnBus();

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset) override;
    void Write(std::uint32_t offset, std::uint32_t value) override;

  private:
    struct Object
    {
        std::uint32_t mask;
        std::uint32_t arbitration;
        std::uint32_t control;
        std::uint32_t data_a;
        std::uint32_t data_b;
    };

    static constexpr std::uint32_t kObjects = 64U;

    [[nodiscard]] std::uint32_t InterruptId() const;
    [[nodiscard]] std::uint32_t Flags(std::uint32_t first, std::uint32_t bit) const;
    void Transfer(std::uint32_t interface, std::uint32_t command);
    void Put(std::uint32_t interface, std::uint32_t command, Object& object);
    void Get(std::uint32_t interface, std::uint32_t command, Object& object);

    EsmModel& esm_;
    std::uint32_t parity_channel_;
    Object objects_[kObjects + 1U]{};
    std::uint32_t status_{0U};
    bool status_asks_{false};
    bool is_bus_off_{false};
};

} // namespace counterpoint::tms570::model

#endif

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA302_SAFETY_GATE_RIG_HPP
#define TESTS_CANOPEN_CIA302_SAFETY_GATE_RIG_HPP

#include "canopen/cia302/safety_gate/safety_gate.hpp"
#include "tests/canopen/device/device_rig.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace counterpoint::cia302
{

/// A gate in front of the device of DeviceRig: real kernel, real SDO server, node-ID 2. What the device answers may be
/// changed on its way, so that it seems to have another configuration.
class GateRig : public device::DeviceRig, public cia301::FrameSink
{
  public:
    GateRig();

    bool Send(const CanFrame& frame) noexcept override;

    /// Every object of 1300h to 13FFh that the device has, with its present value.
    [[nodiscard]] std::vector<ExpectedObject> Configuration();
    /// Milliseconds of gate and device, one SDO each at most.
    void Pass(std::uint32_t milliseconds);
    /// Until the gate is not busy any more, 2000 ms at most.
    void Finish();
    /// The value that the device has.
    [[nodiscard]] std::uint32_t Has(std::uint16_t index, std::uint8_t sub);
    /// Puts `expected` in force: to be called before Begin of the gate.
    void Expect(std::vector<ExpectedObject> list);

    std::vector<ExpectedObject> expected{};
    SafetyExpectation expectation{nullptr, 0U};
    std::array<SlaveSetup, kNodeRoom> slaves{};
    NetworkSetup setup{NodeId{1U}, 1U, 0U, 0U, 0U, nullptr};
    SdoLanes<2U> lanes;
    SdoPool pool;
    std::array<SafetySlot, 2U> slots{};
    SafetyGate gate;
    std::function<bool(CanFrame&)> on_request{}; ///< False: the request is lost.
    std::function<bool(CanFrame&)> on_answer{};  ///< False: the answer is lost.
    std::vector<ObjectAddress> written{};        ///< By the gate, in order.
    std::vector<ObjectAddress> read{};

  private:
    void Answer();

    std::vector<CanFrame> requests_{};
    std::size_t answered_{0U}; ///< Of ports.sent.
};

} // namespace counterpoint::cia302

#endif

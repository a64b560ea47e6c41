// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWO_CPU_DEVICE_HPP
#define VERIFICATION_TWO_CPU_DEVICE_HPP

#include "hal/host/cross_link.hpp"
#include "verification/two_cpu/cpu.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <random>

namespace counterpoint::two_cpu
{

/// How the two CPUs and the link differ from each other. Times of true time.
struct DeviceSetup
{
    Timing timing{};
    std::uint64_t seed{1U};
    std::array<double, 2U> drift_ppm{100.0, -100.0};
    host::WireFaults wire{};
    double second_starts_us{30'000.0}; ///< After the first; less than `operational_us`.
    double operational_us{600'000.0};  ///< When both are told the NMT state.
};

/// Two CPUs, the link, one bus with a sensor and a listener, on true time. [SRS_TWO_016, SRS_TWO_017, SRS_TWO_018]
class Device
{
  public:
    explicit Device(const DeviceSetup& setup);

    /// @brief Everything up to and including `until_us`.
    void RunUntil(double until_us);
    [[nodiscard]] double Now() const
    {
        return now_us_;
    }
    /// @brief Both outputs are in series.
    [[nodiscard]] bool IsOpen()
    {
        return cpus[0U]->IsOpen(now_us_) && cpus[1U]->IsOpen(now_us_);
    }

    std::array<std::unique_ptr<Cpu>, 2U> cpus{};
    std::array<bool, 2U> is_dead{false, false};   ///< Does nothing any more.
    std::array<bool, 2U> cycles_on{false, false}; ///< Goes on with its cycles although its clock stands.
    host::HostWire wire;
    bool sensor_is_silent{false};
    std::uint32_t sensor_faults_ppm{0U}; ///< Pairs of the sensor that are not as they should be.
    std::uint64_t sensor_faults{0U};
    std::uint64_t cycles{0U};
    std::uint64_t pairs_heard{0U}; ///< Complete inverse pairs of this device, by the listener.
    std::uint64_t pairs_bad{0U};   ///< Inverse frames that do not fit their normal frame.

  private:
    struct BusFrame
    {
        double ends_us;
        CanFrame frame;
        int sender; ///< 0, 1: CPU; 2: sensor.
    };

    void RunCpu(std::size_t cpu);
    void RunBus();
    void RunSensor();
    void SendPair();
    void Submit(const CanFrame& frame, int sender, double after_us);
    void Listen(const CanFrame& frame);

    DeviceSetup setup_;
    std::mt19937_64 random_;
    double now_us_{0.0};
    std::array<double, 2U> next_cycle_us_{};
    std::array<double, 2U> period_us_{};
    std::array<std::uint64_t, 2U> cycle_{};
    std::array<double, 2U> first_cycle_us_{};
    std::array<bool, 2U> is_operational_{};
    double next_pair_us_;
    std::deque<BusFrame> bus_{}; ///< Ascending.
    std::uint32_t heard_normal_{0U};
    hal::LinkFrame link_frame_{};
};

} // namespace counterpoint::two_cpu

#endif

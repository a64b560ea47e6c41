// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_MACHINE_HPP
#define VERIFICATION_MODELS_TMS570_MACHINE_HPP

#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/chip/variant.hpp"
#include "verification/models/tms570/ccm_model.hpp"
#include "verification/models/tms570/clock_models.hpp"
#include "verification/models/tms570/dcan_model.hpp"
#include "verification/models/tms570/esm_model.hpp"
#include "verification/models/tms570/gio_model.hpp"
#include "verification/models/tms570/memory_models.hpp"
#include "verification/models/tms570/processor_model.hpp"
#include "verification/models/tms570/rti_model.hpp"
#include "verification/models/tms570/test_models.hpp"
#include "verification/models/tms570/vim_model.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace counterpoint::tms570::model
{

/// A controller made of register models: what the drivers reach through hal/tms570/chip/registers.hpp on a host. One at
/// a time. Each access takes a short time, so that a driver which looks and waits sees time go on. [SRS_TMS_001,
/// SRS_TMS_070]
class Machine
{
  public:
    /// @brief Becomes the controller of this process until it is destroyed.
    explicit Machine(const Variant& variant);
    ~Machine();

    Machine(const Machine&) = delete;
    Machine(Machine&&) = delete;
    Machine& operator=(const Machine&) = delete;
    Machine& operator=(Machine&&) = delete;

    [[nodiscard]] static Machine& Current();

    [[nodiscard]] std::uint32_t Read(std::uint32_t address);
    void Write(std::uint32_t address, std::uint32_t value);
    void Advance(std::uint64_t us);
    /// @brief Wakes nobody; tests the logic if that was asked for.
    void Sleep();

    /// @brief Addresses outside of every peripheral that were accessed.
    [[nodiscard]] const std::vector<std::uint32_t>& Strays() const
    {
        return strays_;
    }
    /// @brief The test of the logic has reset the processor since the last call.
    [[nodiscard]] bool TakeProcessorReset();
    /// @brief True if the last access ended in an abort; then that is over.
    [[nodiscard]] AbortLine TakeAbort();
    [[nodiscard]] std::uint64_t NowUs() const;
    /// @brief After each access while interrupts are not locked: where a test lets the bus and its interrupts happen.
    /// Not called from within itself.
    void SetSurroundings(std::function<void()> surroundings);
    void OfferInterrupts();
    /// @brief Aborts that no test had provoked.
    std::uint32_t real_aborts{0U};
    bool interrupts_locked{false};

    FaultSet faults{};
    EsmModel esm{faults};
    DcanModel dcan1;
    DcanModel dcan2;
    VimModel vim;
    VimTableModel vim_table;
    RtiModel rti;
    GioModel gio{faults};
    CcmModel ccm;
    DccModel dcc;
    SystemModel system;
    StcModel stc;
    PbistModel pbist;
    ProcessorModel processor;

  private:
    struct Range
    {
        std::uint32_t first;
        std::uint32_t bytes;
        Peripheral* peripheral;
    };

    void MapPower(const Variant& variant);
    void Map(std::uint32_t first, std::uint32_t bytes, Peripheral& peripheral);
    [[nodiscard]] const Range* Find(std::uint32_t address);
    void Pass(std::uint64_t ns);

    AbortLine abort_{};
    Peripheral power_[3]{Peripheral(faults), Peripheral(faults), Peripheral(faults)};
    Peripheral system2_{faults};
    Level2RamModel level_2_ram_{faults, esm};
    TcramModel even_{faults};
    TcramModel odd_{faults};
    FlashModel flash_;
    RamModel ram_;
    RamEccModel ram_ecc_;
    FlashMirrorModel mirror_;
    std::vector<Range> ranges_{};
    std::vector<std::uint32_t> strays_{};
    bool processor_reset_{false};
    std::uint64_t now_ns_{0U};
    std::function<void()> surroundings_{};
    bool is_interrupted_{false};
};

} // namespace counterpoint::tms570::model

#endif

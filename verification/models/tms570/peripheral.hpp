// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_PERIPHERAL_HPP
#define VERIFICATION_MODELS_TMS570_PERIPHERAL_HPP

#include "verification/models/tms570/faults.hpp"

#include <cstdint>
#include <map>

namespace counterpoint::tms570::model
{

/// One peripheral behind its registers. What is not modelled keeps what was written.
class Peripheral
{
  public:
    explicit Peripheral(const FaultSet& faults) : faults_(faults)
    {
    }
    virtual ~Peripheral() = default;

    Peripheral(const Peripheral&) = delete;
    Peripheral(Peripheral&&) = delete;
    Peripheral& operator=(const Peripheral&) = delete;
    Peripheral& operator=(Peripheral&&) = delete;

    [[nodiscard]] virtual std::uint32_t Read(const std::uint32_t offset)
    {
        return kept_[offset];
    }
    virtual void Write(const std::uint32_t offset, const std::uint32_t value)
    {
        kept_[offset] = value;
    }
    /// @brief Time goes on.
    virtual void Advance(std::uint64_t /*ns*/)
    {
    }

  protected:
    [[nodiscard]] bool Has(const Fault fault) const
    {
        return faults_.Has(fault);
    }
    [[nodiscard]] std::uint32_t& Kept(const std::uint32_t offset)
    {
        return kept_[offset];
    }

  private:
    const FaultSet& faults_;
    std::map<std::uint32_t, std::uint32_t> kept_{};
};

} // namespace counterpoint::tms570::model

#endif

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_DICTIONARY_FOREIGN_OBJECTS_HPP
#define CANOPEN_CIA301_DICTIONARY_FOREIGN_OBJECTS_HPP

#include "safety_core/kernel/kernel.hpp"

namespace counterpoint::cia301
{

/// Objects that another part of the device keeps. [SRS_OBD_008]
class ForeignObjects
{
  public:
    [[nodiscard]] virtual ObjectReading Read(const ObjectAddress& address) noexcept = 0;
    [[nodiscard]] virtual AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept = 0;

  protected:
    ForeignObjects() noexcept = default;
    ~ForeignObjects() noexcept = default;
    ForeignObjects(const ForeignObjects&) = default;
    ForeignObjects& operator=(const ForeignObjects&) = default;
};

/// The safety objects by the kernel's facade, which is kept by reference. [SRS_OBD_012]
class KernelObjects final : public ForeignObjects
{
  public:
    explicit KernelObjects(Kernel& kernel) noexcept : kernel_(kernel)
    {
    }
    [[nodiscard]] ObjectReading Read(const ObjectAddress& address) noexcept override;
    [[nodiscard]] AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept override;

  private:
    Kernel& kernel_;
};

} // namespace counterpoint::cia301

#endif

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_DICTIONARY_FOREIGN_OBJECTS_HPP
#define CANOPEN_CIA301_DICTIONARY_FOREIGN_OBJECTS_HPP

#include "safety_core/kernel/kernel.hpp"

namespace counterpoint::cia301
{

/// Objects that another part of the device keeps. The dictionary asks for those that its own table does not have.
/// [SRS_OBD_008]
class ForeignObjects
{
  public:
    /// @brief The value of an object, or an abort code.
    [[nodiscard]] virtual ObjectReading Read(const ObjectAddress& address) noexcept = 0;
    /// @brief Writes a value; kNone where it was taken.
    [[nodiscard]] virtual AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept = 0;

  protected:
    ForeignObjects() noexcept = default;
    ~ForeignObjects() noexcept = default;
    ForeignObjects(const ForeignObjects&) = default;
    ForeignObjects& operator=(const ForeignObjects&) = default;
};

/// The safety objects 1300h to 13FFh, reached by the kernel's facade. The kernel is kept by reference. [SRS_OBD_012]
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

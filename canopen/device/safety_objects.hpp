// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_SAFETY_OBJECTS_HPP
#define CANOPEN_DEVICE_SAFETY_OBJECTS_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia301/dictionary/foreign_objects.hpp"

namespace counterpoint::device
{

/// The kernel's objects, reached by its facade. The kernel knows no other objects: where an SRDO mapping names an entry
/// of the own table, the answer becomes not mappable (0604 0041h) instead of unknown (0602 0000h). The kernel is kept
/// by reference. [SRS_DEV_017, SRS_DEV_120]
class SafetyObjects final : public cia301::ForeignObjects
{
  public:
    SafetyObjects(Kernel& kernel, const cia301::EntryTable& own) noexcept;

    [[nodiscard]] ObjectReading Read(const ObjectAddress& address) noexcept override;
    [[nodiscard]] AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept override;

  private:
    [[nodiscard]] bool IsOwn(std::uint32_t key) const noexcept;

    Kernel& kernel_;
    cia301::EntryTable own_;
};

} // namespace counterpoint::device

#endif

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_DICTIONARY_NO_OBJECTS_HPP
#define CANOPEN_CIA301_DICTIONARY_NO_OBJECTS_HPP

#include "canopen/cia301/dictionary/foreign_objects.hpp"

namespace counterpoint::cia301
{

/// The foreign objects of a device without SRDOs: there are none. A kernel that was not started would answer 0800 0022h
/// instead of 0602 0000h. [SRS_OBD_017]
class NoObjects final : public ForeignObjects
{
  public:
    [[nodiscard]] ObjectReading Read(const ObjectAddress& address) noexcept override;
    [[nodiscard]] AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept override;
};

} // namespace counterpoint::cia301

#endif

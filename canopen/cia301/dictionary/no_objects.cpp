// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/no_objects.hpp"

namespace counterpoint::cia301
{

ObjectReading NoObjects::Read(const ObjectAddress& address) noexcept
{
    static_cast<void>(address);
    return ObjectReading{AbortCode::kObjectUnknown, {}};
}

AbortCode NoObjects::Write(const ObjectAddress& address, const ObjectData& data) noexcept
{
    static_cast<void>(address);
    static_cast<void>(data);
    return AbortCode::kObjectUnknown;
}

} // namespace counterpoint::cia301

// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/dictionary/foreign_objects.hpp"

namespace counterpoint::cia301
{

ObjectReading KernelObjects::Read(const ObjectAddress& address) noexcept
{
    return kernel_.ReadObject(address);
}

AbortCode KernelObjects::Write(const ObjectAddress& address, const ObjectData& data) noexcept
{
    return kernel_.WriteObject(address, data);
}

} // namespace counterpoint::cia301

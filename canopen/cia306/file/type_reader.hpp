// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_TYPE_READER_HPP
#define CANOPEN_CIA306_FILE_TYPE_READER_HPP

#include "canopen/cia306/file/device.hpp"

namespace counterpoint::cia306
{
/// Gives every entry the type that its DataType stands for in this file: one of CiA 301, or what an object of type
/// DEFTYPE or DEFSTRUCT describes. [SRS_EDS_027]
void ResolveTypes(Device& device);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_TYPE_READER_HPP

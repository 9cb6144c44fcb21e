// The buffer that kernels print into (lib/debug.glsl), in words: a header, then records of kDebugWords words each:
// thread, source line, kind and number of components, up to four components.
#ifndef HYALITE_SHARED_DEBUG_RECORDS_H
#define HYALITE_SHARED_DEBUG_RECORDS_H
#include "language.h"
SHARED_BEGIN

SHARED_CONSTANT kDebugCount = 0u; // word of the header: number of records written or dropped for lack of room
SHARED_CONSTANT kDebugRoom = 1u;  // capacity in records
SHARED_CONSTANT kDebugPixel = 2u; // the pixel last clicked; kNone: none
SHARED_CONSTANT kDebugHeader = 4u;
SHARED_CONSTANT kDebugWords = 7u;

// Kinds, stored above the number of components.
SHARED_CONSTANT kDebugFloat = 0x10u;
SHARED_CONSTANT kDebugInt = 0x20u;
SHARED_CONSTANT kDebugUint = 0x30u;

SHARED_END
#endif

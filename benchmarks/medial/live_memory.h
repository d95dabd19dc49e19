// Bytes that are allocated by operator new and not yet deleted.
#pragma once

#include <cstddef>

namespace beadmesh::bench {

/// From here on allocations are counted, from zero. One thread only.
void start_counting_memory();
/// Stops counting; the greatest number of bytes that were live at once, the allocator's rounding included.
std::size_t peak_of_counted_memory();

}  // namespace beadmesh::bench

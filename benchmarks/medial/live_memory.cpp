#include "live_memory.h"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace {

bool counting = false;
std::ptrdiff_t live = 0, peak = 0;

void* counted_allocation(std::size_t size) {
  void* block = std::malloc(size > 0 ? size : 1);
  if (!block) throw std::bad_alloc();
  if (counting) {
    live += static_cast<std::ptrdiff_t>(malloc_usable_size(block));
    if (live > peak) peak = live;
  }
  return block;
}

void counted_release(void* block) {
  if (counting && block) live -= static_cast<std::ptrdiff_t>(malloc_usable_size(block));
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
  return counted_allocation(size);
}
void* operator new[](std::size_t size) {
  return counted_allocation(size);
}
void operator delete(void* block) noexcept {
  counted_release(block);
}
void operator delete[](void* block) noexcept {
  counted_release(block);
}
void operator delete(void* block, std::size_t) noexcept {
  counted_release(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  counted_release(block);
}

namespace beadmesh::bench {

void start_counting_memory() {
  live = peak = 0;
  counting = true;
}

std::size_t peak_of_counted_memory() {
  counting = false;
  return static_cast<std::size_t>(peak);
}

}  // namespace beadmesh::bench

#pragma once

namespace raylab {

/// Lets a program's heap keep what is freed for what is allocated next. As glibc is set, it asks the system for blocks
/// of more than some 100 KB one by one, and for the heap's growth by as much, and soon gives both back; then each page
/// of 4 KB is asked for anew by a fault, which takes 2 to 11 microseconds in a virtual machine. Blocks of more than 32
/// MB still come from the system one by one. The process then holds up to 128 MB more than it uses, and of each
/// thread's heap 64 MB of addresses. Call it first: the calling thread's heap is put on large pages, too.
void keep_freed_memory();

/// Lets the calling thread's heap lie on large pages from here on (of a program that keeps its memory, up to some 60
/// MB): one fault of 100 microseconds for 512. With both, a picture of 4096 triangles waits half as long for its first
/// ray.
void put_heap_on_large_pages();

}  // namespace raylab

#pragma once

namespace laver {

/// Throws Error(Output) if anything that was printed to std::cout could not be written.
void flushStandardOutput();

/// Opens the standard descriptors that the process was started without, so that no file it opens
/// takes their place; writing to them fails as before.
void occupyStandardDescriptors();

}  // namespace laver

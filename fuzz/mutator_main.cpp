// The mutator and the crossover that libFuzzer calls, linked into fuzzers alone. One time in four, and where no move
// applies, they use libFuzzer's own mutations of bytes. Other engines have no such mutations and do not call these.
#include <cstring>

#include "fuzz/mutator.hpp"

extern "C" [[gnu::weak]] std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                      std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  if (seed % 4 != 0) {
    if (const auto bytes = graze::fuzz::mutated({data, size}, max_size, seed)) {
      std::memcpy(data, bytes->data(), bytes->size());
      return bytes->size();
    }
  }
  return LLVMFuzzerMutate != nullptr ? LLVMFuzzerMutate(data, size, max_size) : size;
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size,
                                                 const std::uint8_t* other, std::size_t other_size,
                                                 std::uint8_t* out, std::size_t max_size, unsigned int seed) {
  const auto bytes = graze::fuzz::crossed({one, one_size}, {other, other_size}, max_size, seed);
  if (!bytes) return 0;
  std::memcpy(out, bytes->data(), bytes->size());
  return bytes->size();
}

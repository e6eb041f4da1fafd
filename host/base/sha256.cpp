// SPDX-License-Identifier: Apache-2.0
#include "base/sha256.h"

#include <sha2.h>

#include <cstdint>

namespace lobe {

struct Sha256::State {
    SHA2_CTX context;
};

Sha256::Sha256() : state_(std::make_unique<State>()) { SHA256Init(&state_->context); }
Sha256::~Sha256() = default;

void Sha256::add(const void* data, std::size_t bytes) {
    if (bytes) SHA256Update(&state_->context, static_cast<const std::uint8_t*>(data), bytes);
}

std::string Sha256::hex() {
    std::uint8_t digest[SHA256_DIGEST_LENGTH];
    SHA256Final(digest, &state_->context);
    std::string text;
    for (const std::uint8_t byte : digest) {
        text += "0123456789abcdef"[byte >> 4];
        text += "0123456789abcdef"[byte & 15];
    }
    return text;
}

std::string sha256(const std::string& text) {
    Sha256 sum;
    sum.add(text);
    return sum.hex();
}

}  // namespace lobe

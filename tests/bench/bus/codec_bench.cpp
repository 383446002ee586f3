// What it costs to bring a scene to bytes and back.
//
//   codec_bench SCENE.yaml...
#include <chrono>
#include <cstdio>

#include "common/io/scene_file.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/scene_hash.h"

namespace {

template <typename Work>
double milliseconds(const Work& work) {
  constexpr int kTimes = 5;
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kTimes; ++i) work();
  const auto spent = std::chrono::steady_clock::now() - begin;
  return std::chrono::duration<double, std::milli>(spent).count() / kTimes;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace accord;
  for (int i = 1; i < argc; ++i) {
    const auto scene = load_scene(argv[i]).scene;
    if (!scene) return 3;
    const Bytes bytes = encode_scene(*scene);
    const double encode = milliseconds([&] { encode_scene(*scene); });
    const double decode = milliseconds([&] { decode_scene(bytes).value(); });
    const double hash = milliseconds([&] { hash_of(bytes); });
    std::printf("%-28s %9zu bytes, to bytes %7.3f ms, back %7.3f ms, hash %7.3f ms\n",
                scene->name.c_str(), bytes.size(), encode, decode, hash);
  }
}

#!/bin/bash -eu
# Builds every fuzz target as OSS-Fuzz and ClusterFuzzLite ask for it: the compiler and its flags come
# from CC, CXX, CFLAGS and CXXFLAGS, the engine from LIB_FUZZING_ENGINE, the sources are in
# $SRC/ccdfuzz. Leaves in $OUT, for each target T: T, T.options, T_seed_corpus.zip, and T.dict where
# there is one. What the targets need comes with them: libraries are linked statically.
cd -P "$SRC/ccdfuzz"
build=$WORK/ccdfuzz
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None \
  -DCCDFUZZ_TESTS=OFF -DCCDFUZZ_BENCH=OFF -DCCDFUZZ_EXAMPLES=OFF \
  -DCCDFUZZ_FUZZ_ENGINE="$LIB_FUZZING_ENGINE"
cmake --build "$build" --target fuzz_targets witnessed_inputs claim_inputs

seeds=$WORK/seeds
rm -rf "$seeds"
while IFS= read -r target; do
  name=fuzz_$target
  cp "$build/fuzz/$name" "$OUT/"
  cp fuzz/target.options "$OUT/$name.options"  # unless it has its own
  for kind in dict options; do
    if [ -e "fuzz/$target.$kind" ]; then cp "fuzz/$target.$kind" "$OUT/$name.$kind"; fi
  done
  rm -f "$OUT/${name}_seed_corpus.zip"
  fuzz/target_seeds.sh "$build/fuzz" "$target" "$seeds/$target"
  zip -q -j -r "$OUT/${name}_seed_corpus.zip" "$seeds/$target"
done <"$build/fuzz-targets.txt"

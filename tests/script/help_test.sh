#!/bin/sh
# --help of each script prints its usage and does nothing else, from anywhere and through a symbolic link.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/tree" "$work/bin" "$work/elsewhere" "$work/tree/build"
cp -r "$source/script" "$work/tree/script"
# Stand-ins for what would install, build or remove.
for tool in apt-get cmake ninja ctest dpkg-query doxygen npm rm sbatch sudo; do
  printf '#!/bin/sh\necho "%s $*" >>"%s/ran"\n' $tool "$work" >"$work/bin/$tool"
  chmod +x "$work/bin/$tool"
done
cd "$work/elsewhere"
for script in "$source"/script/* "$source/script/slurm/submit"; do
  [ ! -d "$script" ] || continue
  name=${script#"$source/"}
  ln -sf "../tree/$name" link
  for run in "$work/tree/$name" "../tree/$name" ./link; do
    for help in --help -h; do
      code=0
      PATH=$work/bin:$PATH "$run" $help >"$work/out" 2>"$work/err" || code=$?
      [ "$code" = 0 ] || { echo "$run $help: exit code $code" && cat "$work/err" && exit 1; }
      [ ! -e "$work/ran" ] || { echo "$run $help runs:" && cat "$work/ran" && exit 1; }
      [ "$(find "$work/tree" -newer "$work/bin/sudo" -type f)" = '' ] || { echo "$run $help wrote" && exit 1; }
      grep -q "$name" "$work/out" || { echo "$run $help prints:" && cat "$work/out" && exit 1; }
    done
  done
done

# Only a build's folder is emptied.
mkdir -p other/api
code=0
"$work/tree/script/api-docs" "$PWD/other" >"$work/out" 2>&1 || code=$?
case $code in
  2) grep -q 'is no build' "$work/out" || { cat "$work/out" && exit 1; } ;;
  77) ;;
  *) echo "script/api-docs of no build: exit code $code" && exit 1 ;;
esac
[ -d other/api ] || { echo 'script/api-docs removed what is not its own' && exit 1; }

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the finite element code CalculiX (ccx 2.20) from Debian's own source package, with user materials on.
#
#   build_ccx.sh FOLDER      prints the path of the program; a second call finds it built
#
# Debian's binary package is built without CALCULIX_EXTERNAL_BEHAVIOURS_SUPPORT: it opens no material library and
# says nothing (zero stress, exit 0). Everything is written below FOLDER, and nothing needs root. Exit 77, with the
# reason, when the packages or the archive cannot be had (1 where BARRENO_HOSTS=required). CalculiX is under the GPL:
# it is built beside the project, runs as a program of its own and is not part of the project.
set -euo pipefail

version=2.20
release=2.20-1
folder=$(realpath -m "${1:?give the folder to build in}")
program=$folder/ccx
packages=(gfortran make patch bzip2 xz-utils libspooles-dev libarpack2-dev liblapack-dev)

skip() {
  echo "no CalculiX: $*" >&2
  [[ ${BARRENO_HOSTS-} == required ]] && exit 1
  exit 77
}

opens_libraries() { nm -D --undefined-only "$1" 2>/dev/null | grep -q dlopen; }

# The system's own entries of Debian's archive as source entries, which only this call reads; many systems list
# binary packages only.
write_sources() {
  local file
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    if [[ -f $file ]]; then sed -n 's/^deb /deb-src /p' "$file"; fi
  done >sources/all.list
  for file in /etc/apt/sources.list.d/*.sources; do
    if [[ -f $file ]]; then sed 's/^Types:.*/Types: deb-src/' "$file" >"sources/$(basename "$file")"; fi
  done
}

download() {
  mkdir -p sources lists/partial cache/archives/partial
  write_sources
  local options=(-q -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$folder/sources"
    -o "Dir::State::lists=$folder/lists" -o "Dir::Cache=$folder/cache" -o APT::Sandbox::User=root)
  # An entry that holds no sources is no matter: what counts is whether the package comes.
  apt-get "${options[@]}" update >download.log 2>&1 || true
  apt-get "${options[@]}" source --download-only "calculix-ccx=$release" >>download.log 2>&1 ||
    skip "apt found no source package calculix-ccx $release ($(grep -m 1 '^[EW]:' download.log)); see $folder/download.log."
}

unpack() {
  tar xjf "calculix-ccx_$version.orig.tar.bz2"
  tar xJf "calculix-ccx_$release.debian.tar.xz"
  (cd CalculiX && patch -s -p1 <../debian/patches/0001-Adjust-Makefile-for-Build-with-Debian.patch)
}

# The 940 Fortran sources as eight files: starting the compiler takes longer than most of them.
join_sources() {
  local -a sources
  read -ra sources <<<"$(make -pn 2>/dev/null | sed -n 's/^SCCXF = //p')"
  rm -f joined_*.f
  local i
  for i in "${!sources[@]}"; do
    cat "${sources[i]}" >>"joined_$((i % 8)).f"
    echo >>"joined_$((i % 8)).f"
  done
  echo joined_*.f
}

compile() {
  local flags="-O0 -w -fopenmp -fallow-argument-mismatch"
  local fortran
  fortran=$(cd "CalculiX/ccx_$version/src" && join_sources)
  local defines='-DARCH="Linux" -DSPOOLES -DARPACK -DMATRIXSTORAGE -DUSE_MT=1 -DCALCULIX_EXTERNAL_BEHAVIOURS_SUPPORT'
  # legacy: within a file the compiler also checks the sizes of arrays that are passed
  make -C "CalculiX/ccx_$version/src" -j"${JOBS:-$(nproc)}" "ccx_$version" \
    SCCXF="$fortran" CFLAGS="$flags -I/usr/include/spooles $defines" FFLAGS="$flags -std=legacy" >compile.log 2>&1 || {
    tail -n 20 compile.log >&2
    echo "CalculiX did not compile (see above); the log is $folder/compile.log." >&2
    exit 1
  }
}

if opens_libraries "$program"; then echo "$program"; exit 0; fi
missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
done
((${#missing[@]} == 0)) || skip "packages are missing; install them: apt-get install ${missing[*]}"
mkdir -p "$folder"
cd "$folder"
rm -rf CalculiX debian
download
unpack
compile
opens_libraries "CalculiX/ccx_$version/src/ccx_$version" || { echo "the ccx that was built opens no libraries." >&2; exit 1; }
mv "CalculiX/ccx_$version/src/ccx_$version" "$program"
# Source and objects are 60 MB and no longer needed.
rm -rf CalculiX debian cache lists
echo "$program"

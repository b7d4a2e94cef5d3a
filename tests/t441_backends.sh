#!/bin/sh
# Tests how a back end is chosen: names, devices, what is not in this build or on this machine.
. tests/tap.sh
: "${BUILD:=build}" "${CC:=gcc}"
SPH=$BUILD/sph-render

# refused CODE TEXT ARGUMENTS...: exit code, message, and no file
refused() {
    code=$1 text=$2
    shift 2
    rm -rf "$work/film"
    mkdir "$work/film"
    "$SPH" scenes/dambreak.json --end 0.01 -o "$work/film/f-%04d.png" "$@" >"$work/out" 2>&1
    rc=$?
    [ $rc = "$code" ] && grep -qF -- "$text" "$work/out" && [ -z "$(ls "$work/film")" ]
    result $? "$*: exit code $code, $text"
}
refused 2 "there is no such back end; give auto, cpu, cuda, or cuda:N" --backend gpu
refused 2 "it has no devices to choose from" --backend cpu:0
refused 2 "there is no such back end" --backend ""
refused 2 "there is no such back end" --backend :1
"$SPH" -q scenes/dambreak.json --set particles.spacing=0.1 --end 0.05 -o null --backend cpu \
    --report "$work/report.json" && jq -e '.backend | startswith("cpu (")' "$work/report.json" >"$work/out"
result $? "--backend cpu"

devices=$("$SPH" list devices)
case $devices in
*"this build has no CUDA"*)
    refused 3 "--backend cuda: not in this build: build with make CUDA=1" --backend cuda
    refused 3 "not in this build" --backend cuda:1
    ;;
*"  none"*)
    refused 3 "there is no GPU that CUDA can use" --backend cuda
    refused 2 "give the number of a device after the colon" --backend cuda:
    refused 2 "give the number of a device after the colon" --backend cuda:-1
    refused 2 "give the number of a device after the colon" --backend cuda:one
    for block in "" x 0 16 100 544 -32 64x +64 " 64" 64:; do
        refused 2 "give threads of a block after the second colon: 32, 64, ... 512" --backend "cuda:0:$block"
    done
    refused 3 "there is no GPU that CUDA can use" --backend cuda:0:512
    "$SPH" scenes/dambreak.json --set particles.spacing=0.1 --end 0.01 -o null -v >"$work/out" 2>&1
    grep -q "back end cuda passed over: ." "$work/out" && grep -q " on cpu (" "$work/out"
    result $? "auto goes on to the cpu, and says why with -v"
    ;;
*)
    refused 3 "list devices" --backend cuda:1000
    ;;
esac
cat >"$work/both.json" <<EOF
{ "title": "both", "scene": "$PWD/scenes/validation/free-fall.json", "case": "free-fall",
  "methods": [{"name": "here", "set": {"backend": "cpu"}}, {"name": "there", "set": {"backend": "cuda"}}],
  "ladders": [{"name": "step", "set": {"time.step": [0.02, 0.01]}}], "repeats": 1 }
EOF
if "$SPH" study "$work/both.json" -o "$work/both" -q >"$work/out" 2>&1; then
    [ "$(cut -d, -f10 "$work/both/results.csv" | sort -u | grep -cE '^(cpu|cuda)$')" = 2 ]
else
    [ $? = 3 ] && grep -q "both.json, there: " "$work/out" && [ ! -e "$work/both/results.csv" ]
fi
result $? "a study of both back ends"
sed 's/, {"name": "there".*}}\]/]/' "$work/both.json" >"$work/one.json"
"$SPH" study "$work/one.json" -o "$work/one" -q >"$work/out" 2>&1 &&
    grep -q -- "--backend cpu" "$work/one/report.md"
result $? "the command of a study's row names the back end"
echo "$devices" | head -n 1 | grep -qx "devices: GPUs for --backend cuda:N"
result $? "list devices"

# Without CUDA nothing of it is in the program, with it nothing that tests alone run.
nm "$SPH" 2>"$work/err" >"$work/names"
if grep -q " device_cuda$" "$work/names"; then
    ! grep -qE " (kernels_host|device_host|backend_cuda_host)$" "$work/names"
else
    ! grep -qE "kernels_|device_host|cuda_queue|cudaMalloc" "$work/names"
fi
result $? "what is not used is not in the program"
if command -v ldd >"$work/out"; then
    ldd "$SPH" >"$work/out" 2>&1
    ! grep -qE 'libcuda|libcudart|libnv' "$work/out"
    result $? "no library of CUDA is needed to start"
fi
echo "1..$n"

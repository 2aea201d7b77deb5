"""What ptxas reports of the kernels for GPUs: no kernel spills registers or has a stack, and none takes more registers than its kind may. More registers
mean fewer threads that hide the latency of memory: with 56 a multiprocessor has 36 warps in flight, with 72 it has 28, with 128 it has 16.

    kernel_resources.py RESOURCES [--list]
"""

import re
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
ARCHITECTURES = {"sm_80", "sm_90"}
# Kind → most registers. The second visit of bonds has work in few threads.
LIMITS = {"advance": 32, "travel": 72, "list": 32, "boundary condition": 72, "fragments": 96, "pair forces": 160, "pressed strength": 56,
          "dilatation": 64, "force": 72, "second visit": 128, "dilatation of what may yield": 72, "force of what may yield": 128, "with plastic strain": 144, "second visit of what may yield": 192,
          "deformation gradient": 96, "correspondence stress": 192, "correspondence force": 96}
BOUNDARY = ("LoadKernel", "LiftKernel", "DeepTopsKernel", "WetKernel", "ResistKernel", "DampKernel", "ImposeKernel", "ListedTravelKernel", "ReactKernel")
FRAGMENTS = ("MovedKernel", "MovedTogetherKernel", "GatherMembersKernel", "InsertBrokenPairsKernel", "DensityKernel", "SumMembersKernel")
GRADIENT = ("GradientKernel", "RenewGradientKernel", "RenewRateKernel", "FollowBrokenKernel")
STRESS = ("ResponseKernel", "BondLevelStressKernel", "BondLevelEnergyKernel")
ENTRY = re.compile(
    r"Compiling entry function '(\w+)' for '(sm_\d+)'.*?(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads.*?Used (\d+) registers", re.DOTALL)


def kind_of(name):
    for start, kind in (("AdvanceKernel", "advance"), ("::TravelKernel", "travel"), ("GatherKernel", "list"), ("ScatterKernel", "list"),
                        ("GatherBondsKernel", "list"), ("NearnessKernel", "list"), ("MotionSumsKernel", "travel"), ("HotBitsKernel", "list"), ("LostWorkKernel", "list"), ("SumLanesKernel", "list"), *((name, "boundary condition") for name in BOUNDARY),
                        ("PairForcesKernel", "pair forces"), *((f"device::{name}", "fragments") for name in FRAGMENTS),
                        *((f"device::{name}<", "deformation gradient") for name in GRADIENT), *((f"device::{name}<", "correspondence stress") for name in STRESS),
                        *((f"device::{name}<", "correspondence force") for name in ("BondLevelReturnKernel", "CorrespondenceForceKernel")),
                        ("PressedStrengthKernel", "pressed strength"), ("HotStressKernel", "force of what may yield")):
        if start in name:
            return kind
    what = "dilatation" if "DilatationKernel" in name else "force"
    if "Plastic" in name:
        if "Visit)2" in name:
            return "second visit of what may yield"
        return "with plastic strain" if "Kernel<true" in name else f"{what} of what may yield"
    if "Break" in name and "Noting" not in name:
        return "second visit"
    return what


def main():
    file = Path(sys.argv[1])
    if not file.exists():
        print("skipped: nvcc was not found, so that there are no kernels for GPUs")
        return SKIPPED
    entries = ENTRY.findall(file.read_text())
    names = subprocess.run(["c++filt"], input="\n".join(entry[0] for entry in entries), capture_output=True, text=True, check=True).stdout.splitlines()
    faults, most = [], {}
    for name, (_, architecture, stack, stores, loads, registers) in zip(names, entries):
        name = re.sub(r"^.*?run<(.*)>\(.*", r"\1", name).replace("perimpact::", "")
        kind = kind_of(name)
        most[architecture, kind] = max(most.get((architecture, kind), 0), int(registers))
        if int(stack) or int(stores) or int(loads):
            faults.append(f"{architecture}: {name} has a stack of {stack} bytes and spills {stores} bytes")
        if int(registers) > LIMITS[kind]:
            faults.append(f"{architecture}: {name} takes {registers} registers, and a kernel of the kind {kind} may take {LIMITS[kind]}")
    for architecture in sorted(ARCHITECTURES):
        for kind, limit in LIMITS.items():
            if (architecture, kind) not in most:
                faults.append(f"{architecture}: there is no kernel of the kind {kind}")
            elif "--list" in sys.argv:
                print(f"{architecture}  {kind}: {most[architecture, kind]} registers of {limit}")
    print(*faults, sep="\n")
    return 1 if faults else 0


sys.exit(main())

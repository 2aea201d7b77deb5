"""The same file read by meshio: CSV rows as of stages.cpp, including the memory of Python and numpy."""

import re
import sys
import time
from pathlib import Path

import meshio

begin = time.process_time()
meshio.read(sys.argv[1], file_format=sys.argv[2])
seconds = time.process_time() - begin
memory = int(re.search(r"VmHWM:\s*(\d+) kB", Path("/proc/self/status").read_text())[1]) / 1024
print("stage,seconds,memory_mib")
print(f"read,{seconds:.4g},{memory:.4g}")

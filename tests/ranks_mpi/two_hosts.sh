#!/bin/sh
# Runs a command as two processes of mpirun on two "hosts": network namespaces of this machine that are connected by a virtual cable alone, so that all
# messages travel by TCP. Exit code 77, with a sentence, where this is not permitted.
#
#   two_hosts.sh perimpact run deck.yaml
set -u

skip() {
  echo "skipped: $1" >&2
  exit 77
}

for program in ip mpirun nsenter unshare; do
  command -v "$program" > /dev/null || skip "$program is not installed."
done
[ "$(id -u)" = 0 ] || skip "namespaces for a network need root."
unshare --net --uts true 2> /dev/null || skip "this machine does not permit namespaces for a network."

folder=$(mktemp -d)
hosts=
trap 'kill $hosts 2> /dev/null; rm -r "$folder"' EXIT
for number in 1 2; do
  unshare --net --uts sleep 600 &
  hosts="$hosts $!"
done
first=${hosts% *} second=${hosts##* }
first=${first# }
on() {
  host=$1
  shift
  nsenter --target "$host" --net --uts "$@"
}

# a process is in its namespaces once it has become sleep
for host in $first $second; do
  until [ "$(cat "/proc/$host/comm")" = sleep ]; do sleep 0.01; done
done
ip link add cable1 netns "$first" type veth peer name cable2 netns "$second" 2> /dev/null || skip "this machine has no virtual network cables (veth)."
number=0
for host in $first $second; do
  number=$((number + 1))
  on "$host" hostname "host$number"
  on "$host" ip address add "10.77.0.$number/24" dev "cable$number"
  on "$host" ip link set "cable$number" up
  on "$host" ip link set lo up
done

# in place of ssh: called with the host and the command
printf '#!/bin/sh\nshift\nexec nsenter --target %s --net --uts sh -c "$*"\n' "$second" > "$folder/agent"
chmod +x "$folder/agent"

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
on "$first" mpirun --host 10.77.0.1:1,10.77.0.2:1 --map-by node --bind-to none -n 2 --mca mpi_yield_when_idle 1 --mca plm_rsh_agent "$folder/agent" --mca pml ob1 --mca btl tcp,self \
  --mca btl_tcp_if_include 10.77.0.0/24 --mca oob_tcp_if_include 10.77.0.0/24 "$@"

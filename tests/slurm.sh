#!/bin/sh
# tests/slurm.sh LAVER [FOLDER]: eight parts of a picture as an array job of a real Slurm on this
# machine, one of which is put back into the queue in the middle; the merged picture must have the
# bits of one render. Not part of ctest: downloads Debian's packages of Slurm and MUNGE with
# apt-get, unpacks them in FOLDER, installs nothing, and listens on loopback only. Runs as root.
set -eu
laver=$(realpath "$1")
folder=$(realpath -m "${2:-$(mktemp -d)}")
scene=$(realpath "$(dirname "$0")/../scenes/cornell-two-lights.xml")
root=$folder/root
packages="slurmctld slurmd slurm-client slurm-wlm-basic-plugins munge libmunge2 liblua5.3-0
  libhwloc15 libfreeipmi17 libipmimonitoring6 librrd8 libpmix2 libhttp-parser2.9 libjson-c5
  libyaml-0-2 libjwt0 libev4"
if [ ! -d "$root" ]; then
  mkdir -p "$folder/debs"
  # shellcheck disable=SC2086
  (cd "$folder/debs" && apt-get download $packages)
  for deb in "$folder"/debs/*.deb; do dpkg -x "$deb" "$root"; done
fi
libraries=$root/usr/lib/$(gcc -print-multiarch)
export LD_LIBRARY_PATH="$libraries:$libraries/slurm-wlm"
export PATH="$root/usr/bin:$root/usr/sbin:$PATH"
export SLURM_CONF="$folder/slurm.conf"

run=$folder/run
rm -rf "$run"
mkdir -p "$run/state" "$run/spool" "$run/work"
chmod -R 755 "$run"
dd if=/dev/urandom of="$run/munge.key" bs=1024 count=1 2>/dev/null
chmod 400 "$run/munge.key"
host=$(hostname -s)
cat >"$SLURM_CONF" <<END
ClusterName=laver
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$run/munge.socket,cred_expire=5
PluginDir=$libraries/slurm-wlm
StateSaveLocation=$run/state
SlurmdSpoolDir=$run/spool
SlurmctldPidFile=$run/slurmctld.pid
SlurmdPidFile=$run/slurmd.pid
SlurmctldLogFile=$run/slurmctld.log
SlurmdLogFile=$run/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
KillWait=30
SlurmdParameters=config_overrides
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END

pids=
stop() {
  for pid in $pids; do kill "$pid" 2>/dev/null || true; done
}
trap stop EXIT
munged --foreground --force --socket="$run/munge.socket" --key-file="$run/munge.key" \
  --log-file="$run/munged.log" --pid-file="$run/munged.pid" --seed-file="$run/munge.seed" &
pids=$!
sleep 1
slurmctld-wlm -D -c >"$run/ctld.txt" 2>&1 &
pids="$pids $!"
slurmd-wlm -D -N "$host" -d "$root/usr/sbin/slurmstepd-wlm" >"$run/d.txt" 2>&1 &
pids="$pids $!"
until sinfo -h -o %T 2>/dev/null | grep -q idle; do
  sleep 1
  waited=$((${waited:-0} + 1))
  [ "$waited" -lt 60 ] || { echo "Slurm does not start; see $run"; exit 1; }
done

cd "$run/work"
options="--device cpu --size 320x240 --spp ${SPP:-2048}"
cat >parts.sh <<END
#!/bin/sh
#SBATCH --array=0-7
#SBATCH --requeue --open-mode=append
exec $laver $scene --shard "\$SLURM_ARRAY_TASK_ID/8" --resume $options -t 1 -o p\$SLURM_ARRAY_TASK_ID.exr
END
job=$(sbatch --parsable parts.sh)
merge=$(sbatch --parsable --dependency="afterok:$job" --wrap="$laver merge p?.exr -o merged.exr")
until grep -q Rendering "slurm-${job}_1.out" 2>/dev/null; do sleep 0.2; done
sleep 3
scontrol requeue "${job}_1"
until [ -z "$(squeue -h -j "$merge" 2>/dev/null)" ]; do sleep 1; done
grep -H "interrupted\|Going on" slurm-*.out || { echo "no part was interrupted"; exit 1; }
# shellcheck disable=SC2086
"$laver" "$scene" $options -q -o whole.exr
"$laver" compare merged.exr whole.exr --tolerance 0
cmp merged.png whole.png
echo "the merged picture has the bits of one render"

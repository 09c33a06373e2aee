#!/bin/sh
# Runs a command beside a SLURM of this one machine, started for it and stopped afterwards. As root, with the Debian packages slurm-wlm and
# munge; used to test `coulter sweep script --for slurm` where no cluster is at hand.
#
# usage: one_node_slurm.sh COMMAND [ARGUMENTS]
set -eu
[ "$(id -u)" -eq 0 ] || { echo "one_node_slurm.sh: only root can start SLURM" >&2; exit 1; }
folder=$(mktemp -d)
mkdir "$folder/state" "$folder/spool"
host=$(hostname -s)
cat > "$folder/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=5
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$(awk '/MemAvailable/ {print int($2 / 1100)}' /proc/meminfo) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
chmod 755 "$folder"
export SLURM_CONF="$folder/slurm.conf"

stop() {
    for daemon in slurmd slurmctld; do
        [ ! -f "$folder/$daemon.pid" ] || kill "$(cat "$folder/$daemon.pid")" 2>/dev/null || true
    done
    sleep 1
    rm -rf "$folder"
}
trap stop EXIT

if ! munge -n >/dev/null 2>&1; then
    [ -f /etc/munge/munge.key ] || mungekey --create
    mkdir -p /run/munge
    chown -R munge: /run/munge /etc/munge /var/lib/munge /var/log/munge
    setpriv --reuid munge --regid munge --clear-groups munged
fi
slurmctld
slurmd
# The node registers within seconds.
tries=0
until sinfo --noheader --format %t 2>/dev/null | grep -q idle; do
    tries=$((tries + 1))
    [ "$tries" -lt 60 ] || { cat "$folder"/*.log >&2; exit 1; }
    sleep 0.5
done
"$@"

# Functions for a Slurm of four nodes on this machine, in a folder, for one user: no daemon or key of
# the system is used. To be sourced by bash.

# startSlurm FOLDER: starts it; afterwards sbatch, squeue and sinfo speak to it.
startSlurm() {
    slurm=$1
    mkdir -p "$slurm"/{state,spool,log}
    chmod -R go-w "$slurm"
    local base node
    base=$(freePorts)
    head -c 1024 /dev/urandom > "$slurm/munge.key"
    chmod 400 "$slurm/munge.key"
    munged --foreground --force --num-threads 2 --key-file "$slurm/munge.key" \
        --socket "$slurm/munge" --pid-file "$slurm/munge.pid" --log-file "$slurm/log/munge" \
        --seed-file "$slurm/munge.seed" > "$slurm/log/munged" 2>&1 &
    daemons+=($!)
    until_true 'test -S "$slurm/munge"' 'munged does not start'
    slurmConf "$base" > "$slurm/slurm.conf"
    export SLURM_CONF=$slurm/slurm.conf
    slurmctld -D -c -f "$SLURM_CONF" > "$slurm/log/slurmctld" 2>&1 &
    daemons+=($!)
    for node in 1 2 3 4; do
        slurmd -D -f "$SLURM_CONF" -N "n$node" > "$slurm/log/n$node" 2>&1 &
        daemons+=($!)
        nodes[node]=$!
    done
    until_true 'test "$(sinfo -h -t idle -o %D 2> /dev/null)" = 4' 'the four nodes are not idle'
}

# Its settings; a node that is silent for five seconds is down, and its tasks run elsewhere after six.
slurmConf() {
    local user
    user=$(id -un)
    cat << END
ClusterName=scratch
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$slurm/munge,cred_expire=6
CredType=cred/munge
SlurmctldPort=$1
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.%n.pid
SlurmdSpoolDir=$slurm/spool/%n
StateSaveLocation=$slurm/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1
ReturnToService=2
SlurmdTimeout=5
SlurmctldTimeout=5
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
NodeName=n[1-4] NodeHostname=$(hostname) NodeAddr=127.0.0.1 Port=[$(($1 + 1))-$(($1 + 4))] CPUs=1
PartitionName=all Nodes=ALL Default=YES MaxTime=60 State=UP
END
}

# The first of five ports that nobody listens to.
freePorts() {
    local base port
    for ((base = 20000 + $$ % 1000 * 10; ; base += 10)); do
        for ((port = base; port < base + 5; ++port)); do
            ! (exec 3<> "/dev/tcp/127.0.0.1/$port") 2> /dev/null || continue 2
        done
        echo "$base"
        return
    done
}

# until_true CONDITION MESSAGE: waits for other programs, two minutes at most.
until_true() {
    local tries
    for ((tries = 0; tries < 1200; ++tries)); do
        if eval "$1"; then return; fi
        sleep 0.1
    done
    echo "FAILED: $2" >&2
    [ ! -d "$slurm/log" ] || tail -n 5 "$slurm"/log/* >&2
    exit 1
}

# Ends all that startSlurm started, and nothing else.
stopSlurm() {
    local daemon
    for daemon in "${daemons[@]}"; do kill "$daemon" 2> /dev/null || true; done
    for daemon in "${daemons[@]}"; do wait "$daemon" 2> /dev/null || true; done
}
daemons=() nodes=()

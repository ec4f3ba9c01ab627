# What the scripts and the jobs of this folder share. To be sourced.
set -euo pipefail

say() { printf '%s: %s\n' "${SLURM_JOB_NAME:-${0##*/}}" "$*" >&2; }

die() {
    local status=$1
    shift
    say "$*"
    exit "$status"
}

# ---- for those who submit ----

# Where vvr is, for this machine and the nodes: $VVR, else the build beside these scripts, else the PATH's.
find_vvr() {
    local built
    built=$(cd "$VVR_CLUSTER/../.." && pwd)/build/release/cli/vvr
    [ -n "${VVR-}" ] || { [ -x "$built" ] && VVR=$built; } || VVR=$(command -v vvr) ||
        die 1 "found no vvr: neither '$built' nor one in the PATH; set VVR to where it is, on a file system that the nodes see"
    export VVR
}

whole_number() {
    [[ $2 =~ ^[1-9][0-9]*$ ]] || die 1 "$1: '$2' is not a whole number above 0"
}

# Whether an option is among others: given --backend "$@", as a word of its own or with a = and its value.
given() {
    local name=$1 word
    shift
    for word; do
        [[ $word != "$name" && $word != "$name="* ]] || return 0
    done
    return 1
}

# Submits a job and prints its number. A cluster's own options come from the environment: SBATCH_PARTITION, ...
submit() { sbatch --parsable "$@" | cut -d';' -f1; }

# ---- for jobs, on a node ----

restarts_allowed=${VVR_RESTARTS:-5}

cpus() { echo "${SLURM_CPUS_ON_NODE:-1}"; }

# Megabytes that Slurm gives this job on this node; 0 = it does not say.
memory() { echo "${SLURM_MEM_PER_NODE:-$((${SLURM_MEM_PER_CPU:-0} * $(cpus)))}"; }

# Slurm puts a task back into the queue as often as it loses the task's node. One that takes its node down with it must
# not go through the whole cluster.
check_restarts() {
    local restarts=${SLURM_RESTART_COUNT:-0}
    say "on ${SLURMD_NODENAME:-$(hostname)}, restart $restarts of at most $restarts_allowed"
    [ "$restarts" -le "$restarts_allowed" ] ||
        die 69 "was started $((restarts + 1)) times and never came to an end; look into the logs of its nodes, then submit it again"
}

# Whether this is the run that Slurm knows of, not one that it takes for dead and has started again.
is_ours() {
    local job
    job=$(scontrol --oneliner show job "${SLURM_JOB_ID-none}") &&
        [[ $job == *" JobState=RUNNING "* && $job == *" Restarts=${SLURM_RESTART_COUNT:-0} "* ]]
}

# Runs a command. What may be the node's fault is put back into the queue: a file that can't be read or written (2), no
# OpenGL (4), no vvr (126, 127), a crash or the kernel's want of memory (134 to 139). Anything else, and what fails once
# more after all restarts, ends with the command's own status. A task that was told to end (143) is not started again.
run_or_requeue() {
    local status=0
    "$@" || status=$?
    case $status in
        2 | 4 | 126 | 127 | 13[4-9]) ;;
        *) return "$status" ;;
    esac
    if [ "${SLURM_RESTART_COUNT:-0}" -ge "$restarts_allowed" ]; then
        say "failed with status $status, and has had all its restarts"
    elif is_ours && scontrol requeue "$SLURM_JOB_ID"; then
        say "failed with status $status; back into the queue"
    else
        say "failed with status $status, and could not be put back into the queue"
    fi
    exit "$status"
}

#!/bin/bash
# Runs a command by four MPI ranks in two network namespaces, two in each, that reach each other over one virtual cable
# alone, as hosts do. Needs root, iproute2 and Open MPI; takes both namespaces away again.
#
#     benchmarks/mpi_namespaces.sh build/dev/bin/smat-batch-mpi table PROJECT --threads 1 --out table.csv
set -u
folder=$(mktemp -d)
cat > "$folder/agent" <<'AGENT'
#!/bin/sh
# As ssh: HOST COMMAND...
shift
exec ip netns exec smat_b unshare -u sh -c 'hostname smatb; exec sh -c "$*"' sh "$@"
AGENT
chmod +x "$folder/agent"
leave() {
    ip netns del smat_a
    ip netns del smat_b
    rm -r "$folder"
}
trap leave EXIT
ip netns add smat_a && ip netns add smat_b && ip link add smat_va type veth peer name smat_vb || exit 3
for side in a b; do
    ip link set smat_v$side netns smat_$side
    ip netns exec smat_$side ip link set lo up
    ip netns exec smat_$side ip link set smat_v$side up
done
ip netns exec smat_a ip addr add 10.77.0.1/24 dev smat_va
ip netns exec smat_b ip addr add 10.77.0.2/24 dev smat_vb
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
ip netns exec smat_a unshare -u sh -c 'hostname smata; exec "$@"' sh \
    mpirun --mca plm_rsh_agent "$folder/agent" --mca btl self,tcp --mca btl_tcp_if_include 10.77.0.0/24 \
    --mca oob_tcp_if_include 10.77.0.0/24 --mca rmaps_base_oversubscribe 1 \
    -host 10.77.0.1:2,10.77.0.2:2 -n 4 "$@"

"""A batch as a job array: the scripts by themselves, and through a private Slurm of one node."""
import contextlib
import os
import pathlib
import shutil
import socket
import stat
import subprocess
import tempfile
import time
import unittest

from batch_test import BatchCase
from command import TIMEOUT

SERVERS = "munged", "slurmctld", "slurmd", "sbatch"


class SlurmScripts(BatchCase):
    """What --slurm writes, run task by task as Slurm would."""

    def setUp(self):
        super().setUp()
        self.add_plates(5)
        (self.panels / "broken.stl").write_bytes(b"")

    def summaries(self, folder):
        return [(folder / name).read_text() for name in ("batch.json", "batch.csv")]

    def script(self, name):
        return self.out / "slurm" / name

    def run_script(self, name, task=None):
        environment = dict(os.environ, **({"SLURM_ARRAY_TASK_ID": str(task)} if task else {}))
        return subprocess.run(["sh", self.script(name)], env=environment, capture_output=True, text=True, timeout=TIMEOUT)

    def directives(self, name):
        return [line.split(" ", 1)[1] for line in self.script(name).read_text().splitlines() if line.startswith("#SBATCH ")]

    def test_all_tasks_give_the_summary_of_the_batch(self):
        self.batch(None, "--size", "4", status=1)
        expected = self.summaries(self.out)
        shutil.rmtree(self.out)
        result = self.batch(None, "--size", "4", "--slurm")
        self.assertIn("6 panels in 6 tasks", result.stdout)
        self.assertIn("--array=1-6", self.directives("array.sh"))
        codes = [self.run_script("array.sh", task).returncode for task in (4, 1, 6, 2, 3, 5)]
        self.assertEqual([0, 0, 0, 0, 0, 1], sorted(codes))
        self.assertEqual(1, self.run_script("collect.sh").returncode)
        self.assertEqual(expected, self.summaries(self.out))
        self.assert_nothing_half()

    def test_fewer_tasks_than_panels(self):
        self.batch(None, "--slurm", "--max-tasks", "4", "--timeout", "600", "--memory", "4000", "--threads", "2",
                   "--slurm-option=--partition=short", "--slurm-option=--nice")
        directives = self.directives("array.sh")
        for wanted in ("--array=1-4", "--cpus-per-task=2", "--time=25", "--mem=4256M", "--partition=short", "--nice"):
            self.assertIn(wanted, directives)
        for task in (1, 2, 3, 4):
            self.run_script("array.sh", task)
        self.run_script("collect.sh")
        self.assertEqual({"done": 5, "refused": 1}, {o: list(self.outcomes().values()).count(o) for o in set(self.outcomes().values())})

    def test_a_task_that_never_ran_is_named_and_done_later(self):
        self.batch(None, "--slurm")
        for task in (1, 2, 4, 5, 6):
            self.run_script("array.sh", task)
        self.assertEqual(1, self.run_script("collect.sh").returncode)
        self.assertEqual(["not run"], [o for o in self.outcomes().values() if o not in ("done", "refused")])
        result = self.batch(self.out / "batch.toml", status=1)
        self.assertIn("4 were done before", result.stdout)
        self.assertNotIn("not run", self.outcomes().values())

    def test_names_that_a_shell_would_split(self):
        self.out = self.folder / "out it's a $HOME"
        self.batch(None, "--slurm")
        self.assertEqual(1, self.run_script("array.sh", 1).returncode)  # the broken one comes first
        self.assertEqual(0, self.run_script("array.sh", 2).returncode)
        self.assertTrue((self.out / "panels/plate_000/plate_000.bdf").exists())

    def test_submitting(self):
        bin_folder = self.folder / "bin"
        bin_folder.mkdir()
        fake = bin_folder / "sbatch"
        fake.write_text(f'#!/bin/sh\necho "$@" >> {self.folder}/calls\nwc -l < {self.folder}/calls | sed "s/$/;cluster/"\n')
        fake.chmod(fake.stat().st_mode | stat.S_IXUSR)
        result = self.batch(None, "--slurm", "--submit", env=dict(os.environ, PATH=f"{bin_folder}:{os.environ['PATH']}"))
        self.assertIn("submitted job 1, and 2 for the summary", result.stdout)
        first, second = (self.folder / "calls").read_text().splitlines()
        self.assertEqual(f"--parsable {self.script('array.sh')}", first)
        self.assertEqual(f"--parsable --dependency=afterany:1 {self.script('collect.sh')}", second)
        result = self.batch(None, "--slurm", "--submit", status=2, env=dict(os.environ, PATH=str(self.folder / "empty")))
        self.assertIn("slurm.sbatch", result.stderr)


def free_port():
    with contextlib.closing(socket.socket()) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class PrivateSlurm:
    """munged, slurmctld and slurmd of our own, all files in one folder."""

    CONFIGURATION = """ClusterName=private
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldPort={controller_port}
SlurmdPort={node_port}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SchedulerParameters=sched_interval=1,batch_sched_delay=0
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""

    def __init__(self, folder):
        self.folder, self.processes = folder, []
        os.chmod(folder, 0o755)
        host = socket.gethostname().split(".")[0]
        for name in ("state", "spool"):
            (folder / name).mkdir()
        (folder / "munge.key").write_bytes(os.urandom(1024))
        os.chmod(folder / "munge.key", 0o600)
        self.configuration = folder / "slurm.conf"
        self.configuration.write_text(self.CONFIGURATION.format(host=host, folder=folder, controller_port=free_port(),
                                                                node_port=free_port(), cpus=os.cpu_count()))
        self.environment = dict(os.environ, SLURM_CONF=str(self.configuration))

    def start(self):
        """None, or why there is no Slurm."""
        missing = [name for name in SERVERS if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin")]
        if missing:
            return "not installed: " + ", ".join(missing)
        if os.geteuid() != 0:
            return "slurmd needs root"
        self.run("munged", "-F", "--force", *(f"--{what}={self.folder}/munge.{end}" for what, end in
                                              (("socket", "socket"), ("key-file", "key"), ("pid-file", "pid"),
                                               ("log-file", "log"), ("seed-file", "seed"))))
        if not self.comes(lambda: (self.folder / "munge.socket").exists()):
            return "munged does not start: " + self.log("munged")
        for name in ("slurmctld", "slurmd"):
            self.run(name, "-D", "-f", str(self.configuration))
        if not self.comes(lambda: "idle" in self.output("sinfo", "--noheader")):
            return "no node comes up: " + self.log("slurmctld") + self.log("slurmd")
        return None

    def run(self, program, *arguments):
        path = shutil.which(program, path=os.environ["PATH"] + ":/usr/sbin")
        with open(self.folder / f"{program}.txt", "wb") as log:
            self.processes.append(subprocess.Popen([path, *arguments], stdout=log, stderr=log, stdin=subprocess.DEVNULL,
                                                   env=self.environment))

    def log(self, program):
        return (self.folder / f"{program}.txt").read_text(errors="replace")[-600:]

    def output(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=TIMEOUT).stdout

    def comes(self, condition, seconds=40):
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            if condition():
                return True
            time.sleep(0.2)
        return False

    def stop(self):
        for process in reversed(self.processes):
            process.terminate()
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


class SlurmCluster(BatchCase):
    """Through Slurm itself. Skipped where no private Slurm can be started, with the reason."""

    @classmethod
    def setUpClass(cls):
        # Short: the path of a socket is limited.
        cls.place = tempfile.TemporaryDirectory(prefix="slurm", dir="/tmp")
        cls.addClassCleanup(cls.place.cleanup)
        cls.slurm = PrivateSlurm(pathlib.Path(cls.place.name))
        cls.addClassCleanup(cls.slurm.stop)
        reason = cls.slurm.start()
        if reason:
            raise unittest.SkipTest(reason)

    def wait_for_jobs(self):
        self.assertTrue(self.slurm.comes(lambda: not self.slurm.output("squeue", "--noheader").strip(), TIMEOUT),
                        self.slurm.output("squeue") + self.slurm.log("slurmctld"))

    def test_an_array_job_and_its_summary(self):
        self.add_plates(4)
        (self.panels / "broken.stl").write_bytes(b"")
        result = self.batch(None, "--slurm", "--submit", env=self.slurm.environment)
        self.assertIn("5 panels in 5 tasks", result.stdout)
        self.assertIn("submitted job", result.stdout)
        self.wait_for_jobs()
        self.assertTrue((self.out / "batch.json").exists(), list((self.out / "slurm").iterdir()))
        by_slurm = [(self.out / name).read_text() for name in ("batch.json", "batch.csv")]
        self.assertEqual(["refused"] + 4 * ["done"], list(self.outcomes().values()))
        self.assert_nothing_half()
        shutil.rmtree(self.out)
        self.batch(status=1)
        self.assertEqual([(self.out / name).read_text() for name in ("batch.json", "batch.csv")], by_slurm)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A study by Snakemake while its workers are killed gives the rows of one `run --study`.

cluster.py FDEBENCH [--runs N] [--kills K] [--seconds S] [--slurm] [--folder DIR]: N runs in shards of S seconds. Locally K workers
are ended by SIGKILL at random moments. On Slurm (`slurm/start`) K jobs are cancelled, and in the middle a node is set down, later
up again. Prints how much is the same, and both wall and processor times.
"""

import argparse
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
ENGINE = HERE.parent.parent / "benchmarks" / "cluster"
SCHEMES = ["l1", "grunwald_letnikov", "bdf2", "adams_pc", "product_trapezoidal"]
STEPS = [64, 128]


def write_study(path, runs):
    """A study of this number of short runs."""
    scenes = -(-runs // (len(SCHEMES) * len(STEPS)))
    path.write_text(f"schemes = {SCHEMES}\nsteps = {STEPS}\n[[family]]\nscene = \"relaxation\"\n"
                    f"parameters = {{gamma = {{from = 0.1, to = 0.9, count = {scenes}}}}}\n", encoding="utf-8")


def workers(folder):
    """The process ids of fdebench that measure shards in this folder."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            words = (process / "cmdline").read_bytes().split(b"\0")
            if words[1:2] == [b"run"] and (process / "cwd").readlink() == folder:
                found.append(int(process.name))
        except OSError:
            continue  # it has ended
    return found


def kill_worker(folder):
    """Ends a random worker; whether there was one."""
    found = workers(folder)
    if not found:
        return False
    try:
        os.kill(random.choice(found), signal.SIGKILL)
    except ProcessLookupError:
        return False
    return True


def slurm(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()


def cancel_job(_):
    """Cancels a random running job that examines or times; whether there was one."""
    jobs = [job.split("|")[0] for job in slurm("squeue", "--noheader", "--states=RUNNING", "--format=%i|%j")
            if job.split("|")[1].startswith(("examine", "time"))]
    if jobs:
        slurm("scancel", job := random.choice(jobs))
        print("cancelled job", job, flush=True)
    return bool(jobs)


def set_node_down():
    """While a job runs there, or after half a minute without one."""
    for _ in range(60):
        if slurm("squeue", "--noheader", "--states=RUNNING", "--nodelist=node2"):
            break
        time.sleep(0.5)
    slurm("scontrol", "update", "nodename=node2", "state=down", "reason=test")
    print("node2 is down", flush=True)
    time.sleep(10)
    # A node that answers may have come back by itself (ReturnToService): then there is nothing to resume.
    if slurm("sinfo", "--noheader", "--nodes=node2", "--format=%T")[0].startswith("down"):
        slurm("scontrol", "update", "nodename=node2", "state=resume")
    print("node2 is up", flush=True)


class Disturber(threading.Thread):
    """Calls the action until it has succeeded `kills` times, at random moments; on Slurm a node goes down half way."""

    def __init__(self, folder, kills, action, longest):
        super().__init__(daemon=True)
        self.folder, self.kills, self.action, self.longest = folder, kills, action, longest
        self.made, self.ended = 0, threading.Event()

    def run(self):
        while self.made < self.kills and not self.ended.wait(random.uniform(0.0, self.longest)):
            if not self.action(self.folder):
                continue
            self.made += 1
            if self.action is cancel_job and self.made == self.kills // 2 + 1:
                set_node_down()


def measured(command, folder):
    """Runs the command; its wall and processor seconds."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    with open(folder / "log.txt", "a", encoding="utf-8") as log:
        run = subprocess.run(command, cwd=folder, stdout=log, stderr=subprocess.STDOUT, check=False)
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if run.returncode:
        sys.exit((folder / "log.txt").read_text(encoding="utf-8")[-5000:] + f"\n{command}: exit code {run.returncode}")
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("fdebench")
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--kills", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=2.0)
    parser.add_argument("--slurm", action="store_true")
    parser.add_argument("--folder", type=pathlib.Path)
    options = parser.parse_args()
    folder = pathlib.Path(options.folder or tempfile.mkdtemp(prefix="cluster")).resolve()
    folder.mkdir(exist_ok=True)
    write_study(folder / "study.toml", options.runs)

    print("plain run: {:.1f} s, {:.1f} s of processors".format(
        *measured([options.fdebench, "run", "--study", "study.toml", "--out", "plain.jsonl"], folder)), flush=True)
    disturber = Disturber(folder, options.kills, cancel_job if options.slurm else kill_worker, 3.0 if options.slurm else 1.0)
    disturber.start()
    print("snakemake: {:.1f} s, {:.1f} s of processors".format(*measured(
        ["snakemake", "--snakefile", ENGINE / "Snakefile", "--profile", ENGINE / "profiles" / ("slurm" if options.slurm else "local"),
         "--config", "study=study.toml", f"fdebench={options.fdebench}", f"seconds={options.seconds}"], folder)), flush=True)
    disturber.ended.set()
    disturber.join()
    print(f"{disturber.made} of {options.kills} {'jobs cancelled' if options.slurm else 'workers killed'}, "
          f"{len(list((folder / 'timed').iterdir()))} shards")
    assert disturber.made == options.kills, "the study ended before the last kill"
    subprocess.run([sys.executable, HERE / "same_rows.py", folder / "plain.jsonl", folder / "results.jsonl"], check=True)
    assert (folder / "report" / "index.html").stat().st_size > 0
    if not options.folder:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()

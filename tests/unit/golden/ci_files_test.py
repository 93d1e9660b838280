#!/usr/bin/env python3
"""The files that `golden init` writes for CI systems, run step by step: every command, each job in a clone of its own,
artifacts and caches as folders. Left out: what fetches and builds Steradian.

usage: ci_files_test.py STERADIAN SOURCE_FOLDER SCRATCH_FOLDER
Needs the Python package PyYAML; exit status 77 (skipped) without it.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

try:
    import yaml
except ImportError:
    print("SKIPPED: the Python package PyYAML is not installed")
    sys.exit(77)

IDENTITY = ("-c", "user.name=test", "-c", "user.email=test@example.org", "-c", "init.defaultBranch=main")
BUILDS = ("Get Steradian", "Find its commit", "Install what it needs", "Build it")


def git(folder, *words):
    subprocess.run(["git", "-C", folder, *IDENTITY, *words], check=True, stdout=subprocess.DEVNULL)


def replace_folder(source, target):
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(source, target)


class Runner:
    """A repository with a suite, and what a CI system keeps of its jobs."""

    def __init__(self, steradian, source, scratch):
        shutil.rmtree(scratch, ignore_errors=True)
        self.scratch, self.repository = scratch, scratch / "repository"
        (scratch / "home/steradian/bin").mkdir(parents=True)
        (scratch / "home/steradian/bin/steradian").symlink_to(steradian)
        (scratch / "home/gh").write_text(f"#!/bin/sh\necho \"$@\" >> {scratch}/comments.txt\ntest -s \"$5\"\n")
        (scratch / "home/gh").chmod(0o755)
        (self.repository / "scenes").mkdir(parents=True)
        for name in ("cornell", "veach"):
            shutil.copy(source / f"assets/scenes/{name}.gltf", self.repository / "scenes")
        git(self.repository, "init")
        self.steradian("golden", "init", "scenes")
        suite = self.repository / "golden/suite.json"
        suite.write_text(re.sub(r'"size": *"[^"]*"', '"size": "32x24"', suite.read_text()))
        self.steradian("golden", "run", "golden/suite.json", "--output", "../first", status=1)
        self.steradian("golden", "approve", "golden/suite.json", "--output", "../first")
        git(self.repository, "add", "-A")
        git(self.repository, "commit", "-m", "goldens")

    def steradian(self, *words, status=0):
        ran = subprocess.run([self.scratch / "home/steradian/bin/steradian", *words], cwd=self.repository, check=False,
                             capture_output=True, text=True)
        assert ran.returncode == status, f"{words}: {ran.returncode}\n{ran.stdout}{ran.stderr}"

    def clone(self, name):
        folder = self.scratch / "jobs" / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.parent.mkdir(exist_ok=True)
        git(self.scratch, "clone", self.repository, folder)
        return folder

    def bash(self, script, folder, environment):
        """The exit status of a script, as both systems run it: it ends at the first command that fails."""
        home = self.scratch / "home"
        everything = {**os.environ, "HOME": str(home), "PATH": f"{home}:{home}/steradian/bin:{os.environ['PATH']}",
                      **environment}
        ran = subprocess.run(["bash", "-eo", "pipefail", "-c", script], cwd=folder, env=everything, check=False,
                             capture_output=True, text=True)
        print(ran.stdout + ran.stderr)
        return ran.returncode


class GitHub(Runner):
    """Runs github-actions.yml."""

    runs = 0

    def workflow(self):
        """The exit status of each job, and the summary."""
        self.runs += 1
        jobs = yaml.safe_load((self.repository / "golden/github-actions.yml").read_text())["jobs"]
        shutil.rmtree(self.scratch / "artifacts", ignore_errors=True)
        self.summary = self.scratch / "summary.md"
        self.summary.write_text("")
        status = {}
        for name, job in jobs.items():
            parts = job.get("strategy", {}).get("matrix", {}).get("part", [1])
            for part in parts:
                values = {"matrix.part": part, "strategy.job-total": len(parts), "github.run_id": self.runs,
                          "github.run_attempt": 1}
                failed = [status[needed] for needed in [job["needs"]] if status[needed]] if "needs" in job else []
                if failed and "if" not in job:
                    status[name] = 1
                    continue
                status[name] = max(status.get(name, 0), self.job(f"{name}_{part}", job["steps"], values))
        return status

    def job(self, name, steps, values):
        folder, status = self.clone(name), 0
        for step in steps:
            if step.get("name") in BUILDS or "checkout" in step.get("uses", "") or step.get("id") == "cache":
                continue
            condition = step.get("if", "")
            if status and "always()" not in condition:
                continue
            files = re.search(r"hashFiles\('([^']*)'\)", condition)
            if files and not (folder / files[1]).exists():
                continue
            fill = lambda text: re.sub(r"\$\{\{ ([^}]*) \}\}", lambda m: str(values.get(m[1], "12")), str(text))
            if "run" in step:
                environment = {key: fill(value) for key, value in step.get("env", {}).items()}
                environment["GITHUB_STEP_SUMMARY"] = str(self.summary)
                status = max(status, self.bash(fill(step["run"]), folder, environment))
            else:
                self.files(step["uses"].split("@")[0], {k: fill(v) for k, v in step["with"].items()}, folder)
        return status

    def files(self, action, options, folder):
        """An action that moves files."""
        artifacts, caches = self.scratch / "artifacts", self.scratch / "caches"
        if action == "actions/upload-artifact":
            replace_folder(folder / options["path"], artifacts / options["name"])
        elif action == "actions/download-artifact" and "name" in options:
            replace_folder(artifacts / options["name"], folder / options["path"])
        elif action == "actions/download-artifact":
            for found in sorted(artifacts.glob(options["pattern"])):
                replace_folder(found, folder / options["path"] / found.name)
        elif action == "actions/cache/save":
            replace_folder(folder / options["path"], caches / options["key"])
        elif action == "actions/cache/restore":
            found = sorted(caches.glob(options["restore-keys"] + "*")) if caches.exists() else []
            if found:
                replace_folder(found[-1], folder / options["path"])
        else:
            raise AssertionError(f"an action that this test does not know: {action}")


class GitLab(Runner):
    """Runs gitlab-ci.yml."""

    def pipeline(self):
        """The exit status of each job."""
        jobs = yaml.safe_load((self.repository / "golden/gitlab-ci.yml").read_text())
        kept, times = self.scratch / "golden-parts", self.scratch / "golden-times"
        shutil.rmtree(kept, ignore_errors=True)
        status = {}
        for name in ("golden-times", "golden", "golden-report"):
            count = jobs[name].get("parallel", 1)
            for index in range(1, count + 1):
                folder = self.clone(f"{name}_{index}")
                for folder_of_others in (kept, times):
                    if folder_of_others.exists():
                        replace_folder(folder_of_others, folder / folder_of_others.name)
                ended = self.bash("\n".join(jobs[name]["script"]), folder,
                                  {"CI_NODE_INDEX": str(index), "CI_NODE_TOTAL": str(count)})
                status[name] = max(status.get(name, 0), ended)
                for folder_of_others in (kept, times):
                    if (folder / folder_of_others.name).exists():
                        shutil.copytree(folder / folder_of_others.name, folder_of_others, dirs_exist_ok=True)
        self.report = self.scratch / "jobs/golden-report_1/golden-results"
        return status


def damage(runner):
    """Exchanges the goldens of both tests."""
    one, other = sorted((runner.repository / "golden/goldens").glob("*.exr"))
    pixels = one.read_bytes()
    one.write_bytes(other.read_bytes())
    other.write_bytes(pixels)
    git(runner.repository, "commit", "-am", "goldens exchanged")


def main():
    steradian, source, scratch = (Path(word).resolve() for word in sys.argv[1:4])
    github = GitHub(steradian, source, scratch / "github")
    assert github.workflow() == {"times": 0, "run": 0, "report": 0}
    assert "2 of 2 passed" in github.summary.read_text(), github.summary.read_text()
    assert "pr comment 12" in (github.scratch / "comments.txt").read_text()
    assert github.workflow() == {"times": 0, "run": 0, "report": 0}
    assert (github.scratch / "jobs/run_1/golden-times/run.json").exists(), "the second run knows the times of the first"
    damage(github)
    assert github.workflow() == {"times": 0, "run": 1, "report": 1}
    assert "0 of 2 passed" in github.summary.read_text(), github.summary.read_text()
    assert (github.scratch / "artifacts/golden-report/report.html").exists()

    gitlab = GitLab(steradian, source, scratch / "gitlab")
    assert gitlab.pipeline() == {"golden-times": 0, "golden": 0, "golden-report": 0}
    assert gitlab.pipeline() == {"golden-times": 0, "golden": 0, "golden-report": 0}
    assert (gitlab.scratch / "jobs/golden_1/golden-times/run.json").exists()
    damage(gitlab)
    assert gitlab.pipeline() == {"golden-times": 0, "golden": 1, "golden-report": 1}
    assert (gitlab.report / "junit.xml").exists() and (gitlab.report / "report.html").exists()
    print("every command of both files works")


if __name__ == "__main__":
    main()

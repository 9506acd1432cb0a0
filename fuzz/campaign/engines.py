"""The two engines that drive the targets, libFuzzer and AFL++: how each is built, asked to run for a while, and asked
to minimise. Both read and write the same pools: one file an input, named by the hash of its bytes."""

import configparser
import hashlib
import os
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from targets import BadInput, Target

MEMORY_MB = 3000
INPUT_SECONDS = 300  # a single input that runs longer is a finding; of wall clock, on a machine that may be busy


@dataclass
class Seen:
    """What a slice shows of itself while it runs."""

    executions: int = 0
    per_second: int = 0
    coverage: int = 0
    corpus: int = 0
    reached: int = 0
    counted: int = 0


def copy_inputs(source: Path, pool: Path) -> int:
    """Copies files under the hash of their bytes; the number of new ones."""
    pool.mkdir(parents=True, exist_ok=True)
    new = 0
    for file in source.iterdir() if source.is_dir() else ():
        if not file.is_file() or file.name.startswith("."):
            continue
        data = file.read_bytes()
        to = pool / hashlib.sha1(data).hexdigest()
        if not to.exists():
            to.write_bytes(data)
            new += 1
    return new


def count(pool: Path) -> int:
    return sum(1 for _ in pool.iterdir()) if pool.is_dir() else 0


def read_share(line: str, seen: Seen) -> None:
    """The line that a target prints at its end."""
    share = re.match(r"(\d+) of (\d+) executions reached a law", line)
    if share:
        seen.reached, seen.counted = map(int, share.groups())


class Programs:
    """Built in a directory of their own, by the compiler that the engine wants."""

    engine = "libfuzzer"
    compiler = "clang++-14"
    interrupted = 72  # the exit code of a program that was asked to end
    merges_into_empty = False  # whether `merge` wants a folder of its own for each target

    def __init__(self, source: Path, build: Path):
        self.source = source
        self.directory = build

    def environment(self) -> dict[str, str]:
        """Sanitizers find their symboliser, and print stacks of undefined behaviour."""
        ours = {"UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1"}
        symbolizer = shutil.which("llvm-symbolizer-14") or shutil.which("llvm-symbolizer")
        if symbolizer:
            ours["ASAN_SYMBOLIZER_PATH"] = symbolizer
        return {**ours, **os.environ}

    def fuzzer(self, target: Target) -> str:
        return str(self.directory / "fuzz" / f"graze_fuzz_{target.name}")

    def replay(self, target: Target) -> str:
        return str(self.directory / "fuzz" / f"graze_replay_{target.name}")

    def build(self, targets: list[Target], jobs: int) -> None:
        compiler = shutil.which(self.compiler)
        if not compiler:
            raise BadInput(f"--engine {self.engine} needs {self.compiler}; ./run packages lists what to install")
        steps = [["cmake", "-S", str(self.source), "-B", str(self.directory), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                  f"-DCMAKE_CXX_COMPILER={compiler}", "-DGRAZE_FUZZ=ON", "-DGRAZE_ASSERTIONS=ON"],
                 ["cmake", "--build", str(self.directory), f"-j{jobs}", "--target",
                  *(f"graze_{kind}_{target.name}" for target in targets for kind in ("fuzz", "replay"))]]
        for step in steps:
            if subprocess.run(step, stdout=2, env=self.environment(), check=False).returncode != 0:
                raise BadInput("the build failed: " + " ".join(step))

    def slice(self, target: Target, pool: Path, work: Path, seconds: int) -> list[str]:
        # Entropic scheduling counts every feature of every execution against every input: half of the time of targets as
        # quick as these.
        options = ["-print_final_stats=1", "-entropic=0", f"-max_total_time={seconds}", f"-rss_limit_mb={MEMORY_MB}",
                   f"-timeout={INPUT_SECONDS}", "-reload=10", f"-artifact_prefix={work}/"]
        dictionary = self.source / "fuzz" / "dictionaries" / f"{target.name}.dict"
        if dictionary.exists():
            options.append(f"-dict={dictionary}")
        # What the target wants of the engine, in the form that ClusterFuzz reads as well.
        wishes = configparser.ConfigParser()
        wishes.read(self.source / "fuzz" / "options" / f"{target.name}.options", encoding="utf-8")
        if wishes.has_section("libfuzzer"):
            options += [f"-{name}={value}" for name, value in wishes.items("libfuzzer")]
        return [self.fuzzer(target), *options, str(pool)]

    def read_line(self, line: str, seen: Seen) -> None:
        """A line of the engine's progress."""
        status = re.match(r"#(\d+)\s", line)
        if status:
            seen.executions = int(status.group(1))
            for name, pattern in (("coverage", r"cov: (\d+)"), ("corpus", r"corp: (\d+)"),
                                  ("per_second", r"exec/s: (\d+)")):
                found = re.search(pattern, line)
                if found:
                    setattr(seen, name, int(found.group(1)))
        read_share(line, seen)

    def read_files(self, work: Path, seen: Seen) -> None:
        """Of an engine that writes its progress to files."""

    def crashes(self, work: Path) -> list[Path]:
        return sorted(file for file in work.iterdir() if re.match(r"(crash|oom|timeout|leak)-", file.name)
                      and file.suffix != ".small")

    def collect(self, work: Path, pool: Path) -> None:
        """Brings new inputs into the pool, where the engine does not do so itself."""

    def merge(self, target: Target, pool: Path, into: Path) -> list[str]:
        """Adds to `into` the inputs of `pool` that show what those in `into` do not."""
        return [self.fuzzer(target), "-merge=1", f"-rss_limit_mb={MEMORY_MB}", f"-timeout={INPUT_SECONDS}",
                f"-artifact_prefix={into}.failed-", str(into), str(pool)]

    def minimise(self, target: Target, crash: Path, small: Path, seconds: int) -> list[str]:
        return [self.fuzzer(target), "-minimize_crash=1", f"-max_total_time={seconds}", f"-rss_limit_mb={MEMORY_MB}",
                f"-timeout={INPUT_SECONDS}", f"-exact_artifact_path={small}", str(crash)]


class Afl(Programs):
    """AFL++ on the very same targets, by its driver for them. Its own queue is kept beside the pool."""

    engine = "afl"
    compiler = "afl-clang-fast++"
    interrupted = 0
    merges_into_empty = True

    def environment(self) -> dict[str, str]:
        ours = {"AFL_NO_UI": "1", "AFL_AUTORESUME": "1", "AFL_SKIP_CPUFREQ": "1", "AFL_NO_AFFINITY": "1",
                "AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES": "1", "AFL_QUIET": "1", "AFL_ALLOW_TMP": "1",
                "UBSAN_OPTIONS": "halt_on_error=1:abort_on_error=1:symbolize=0:print_stacktrace=0",
                "ASAN_OPTIONS": "abort_on_error=1:symbolize=0:detect_leaks=0"}
        return {**ours, **os.environ}

    def __init__(self, source: Path, build: Path):
        super().__init__(source, build)
        self.before: dict[Path, int] = {}  # executions of earlier slices, which AFL++ continues counting from

    def slice(self, target: Target, pool: Path, work: Path, seconds: int) -> list[str]:
        earlier = Seen()
        self.before[work] = 0
        self.read_files(work, earlier)
        self.before[work] = earlier.executions
        return ["afl-fuzz", "-V", str(seconds), "-t", f"{1000 * INPUT_SECONDS}", "-m", "none", "-i", str(pool),
                "-o", str(work / "queue"), "--", self.fuzzer(target)]

    def read_line(self, line: str, seen: Seen) -> None:
        read_share(line, seen)

    def read_files(self, work: Path, seen: Seen) -> None:
        file = work / "queue" / "default" / "fuzzer_stats"
        if not file.exists():
            return
        numbers = dict(re.findall(r"^(\w+)\s*: ([\d.]+)", file.read_text(), re.MULTILINE))
        seen.executions = max(0, int(numbers.get("execs_done", 0)) - self.before[work])
        seen.per_second = int(float(numbers.get("execs_per_sec", 0)))
        seen.coverage = int(numbers.get("edges_found", 0))
        seen.corpus = int(numbers.get("corpus_count", 0))

    def crashes(self, work: Path) -> list[Path]:
        found = [file for kind in ("crashes", "hangs") for file in (work / "queue" / "default" / kind).glob("id:*")
                 if file.suffix != ".small"]
        return sorted(found)

    def collect(self, work: Path, pool: Path) -> None:
        copy_inputs(work / "queue" / "default" / "queue", pool)

    def merge(self, target: Target, pool: Path, into: Path) -> list[str]:
        return ["afl-cmin", "-A", "-t", f"{1000 * INPUT_SECONDS}", "-m", "none", "-i", str(pool), "-o", str(into), "--",
                self.fuzzer(target)]

    def minimise(self, target: Target, crash: Path, small: Path, seconds: int) -> list[str]:
        return ["timeout", str(seconds), "afl-tmin", "-t", f"{1000 * INPUT_SECONDS}", "-m", "none", "-i", str(crash),
                "-o", str(small), "--", self.fuzzer(target)]

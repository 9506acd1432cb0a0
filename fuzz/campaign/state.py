"""What a campaign has done, in a JSON file that is replaced as a whole, so that a stop at any time loses a slice at
most.

A campaign is so many core-seconds. While it is unfinished the same command continues it; after it a new one
begins, on the corpora that the last one left."""

import json
import os
from dataclasses import asdict, dataclass, field
from pathlib import Path

from targets import BadInput

SCHEMA = "graze.fuzz/1"


@dataclass
class Done:
    """Of one target, in this campaign."""

    seconds: float = 0  # of a core
    executions: int = 0
    slices: int = 0
    coverage: int = 0  # edges of our code that the corpus reaches, as the engine counts them
    corpus: int = 0  # inputs
    reached: int = 0  # executions that reached a law, of `counted`, where the target counts them
    counted: int = 0
    crashes: int = 0  # inputs that failed, copies of one mechanism included
    new: list[str] = field(default_factory=list)  # findings saved by this campaign
    known: list[str] = field(default_factory=list)  # saved before, and met again


@dataclass
class State:
    engine: str
    finished: bool = False
    rounds: int = 0
    targets: dict[str, Done] = field(default_factory=dict)
    minimised: dict[str, int] = field(default_factory=dict)  # inputs of a pool after it was last minimised
    total_seconds: float = 0  # of all campaigns on these corpora

    def of(self, name: str) -> Done:
        return self.targets.setdefault(name, Done())

    def seconds(self) -> float:
        return sum(done.seconds for done in self.targets.values())


def load(file: Path, engine: str) -> State:
    if not file.exists():
        return State(engine)
    try:
        data = json.loads(file.read_text(encoding="utf-8"))
        if data.pop("schema") != SCHEMA:
            raise ValueError("another schema")
        data["targets"] = {name: Done(**done) for name, done in data["targets"].items()}
        state = State(**data)
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise BadInput(f"{file}: not a state of a fuzz campaign ({error}); move it away to begin anew") from error
    if state.finished:
        return State(engine, minimised=state.minimised, total_seconds=state.total_seconds)
    if state.engine != engine:
        raise BadInput(f"{file}: an unfinished campaign of --engine {state.engine}; finish it, or move the file away")
    return state


def save(file: Path, state: State) -> None:
    beside = file.with_suffix(".new")
    beside.write_text(json.dumps({"schema": SCHEMA, **asdict(state)}, indent=1) + "\n", encoding="utf-8")
    os.replace(beside, file)

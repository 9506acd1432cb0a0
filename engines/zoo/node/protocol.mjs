// Speaks graze.engine/1, graze.question/1 and graze.answer/1 (docs/reference/protocol.md) on standard input and output.
//
// Whoever imports this file prints nothing else on standard output.
//
//   serve(engine, queries)
//     engine   the fields of graze.engine/1 beside `schema`, `timed` and `queries`
//     queries  name of a query -> { declares, ask }
//       declares  the value of the query in graze.engine/1: `answers`, and what is promised
//       ask       question -> { run, read, release }
//         run()      the engine's own call, and nothing else: this is what `ns` measures
//         read(raw)  what run() returned -> the fields of graze.answer/1 (`outcome`, `time`, ...)
//         release()  gives back what ask() allocated; may be left out
//
// ask() and read() may throw Unsupported: the engine does not support the question. Anything else that is thrown, by the
// adapter or by the engine (a trap of WASM, a panic, an abort), ends the process with kCrashed: an instance that has
// trapped may hold half-written state, and must not answer again.
//
// Reading and writing are synchronous, one line at a time: no question is read before the last one is answered.

import { readSync, writeSync } from "node:fs";

const kCrashed = 70;
const kReadBytes = 65536;
const kPauseMs = 1;

export class Unsupported extends Error {}

export function serve(engine, queries) {
  const declared = Object.fromEntries(Object.entries(queries).map(([name, query]) => [name, query.declares]));
  write_line({ schema: "graze.engine/1", ...engine, timed: true, queries: declared });

  for (const line of lines_of_stdin()) {
    if (line.trim() === "") continue;
    try {
      write_line(answer(JSON.parse(line), queries));
    } catch (error) {
      crash(error);
    }
  }
  process.exit(0);
}

// Prints why, and ends the process as one that crashed. Engines that abort outside of a call come here, too.
export function crash(error) {
  try {
    writeSync(2, `${error?.stack ?? error}\n`);
  } finally {
    process.exit(kCrashed);
  }
}

// Standard output belongs to the answers; what an engine prints goes to standard error.
console.log = console.info = console.debug = console.error;

process.on("uncaughtException", crash);
process.on("unhandledRejection", crash);

function answer(question, queries) {
  const head = { schema: "graze.answer/1", id: question.id };
  if (question.t_max === "inf") question.t_max = Infinity;
  try {
    const query = queries[question.query];
    if (query === undefined) throw new Unsupported(`no query ${question.query}`);
    const call = query.ask(question);
    const timing = question.repeat > 0 ? time(call, question.repeat) : {};
    const fields = call.read(call.run());
    call.release?.();
    return { ...head, ...fields, ...timing };
  } catch (error) {
    if (!(error instanceof Unsupported)) throw error;
    return { ...head, outcome: "unsupported", message: error.message };
  }
}

// The median of `count` calls. They are timed one by one; the clock itself takes some 50 ns of each.
function time(call, count) {
  const taken = new Float64Array(count);
  for (let k = 0; k < count; ++k) {
    const start = performance.now();
    call.run();
    taken[k] = performance.now() - start;
  }
  taken.sort();
  return { ns: Math.round(taken[count >> 1] * 1e6), native: false };
}

// JSON has no numbers that are none: the protocol spells them.
function spell(key, value) {
  if (typeof value !== "number" || Number.isFinite(value)) return value;
  return Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

function write_line(document) {
  let rest = Buffer.from(`${JSON.stringify(document, spell)}\n`);
  while (rest.length > 0) {
    rest = rest.subarray(try_again(() => writeSync(1, rest)));
  }
}

function* lines_of_stdin() {
  const buffer = Buffer.alloc(kReadBytes);
  let kept = [];
  for (;;) {
    const count = try_again(() => readSync(0, buffer, 0, kReadBytes, null), 0);
    if (count === 0) break;
    let from = 0;
    for (let end = buffer.indexOf(10); end >= 0 && end < count; end = buffer.indexOf(10, from)) {
      kept.push(Buffer.from(buffer.subarray(from, end)));
      yield Buffer.concat(kept).toString("utf8");
      kept = [];
      from = end + 1;
    }
    if (from < count) kept.push(Buffer.from(buffer.subarray(from, count)));
  }
  if (kept.length > 0) yield Buffer.concat(kept).toString("utf8");
}

// A pipe that its other end has made non-blocking says EAGAIN instead of waiting.
function try_again(transfer, at_end) {
  for (;;) {
    try {
      return transfer();
    } catch (error) {
      if (error.code === "EOF" && at_end !== undefined) return at_end;
      if (error.code === "EPIPE") process.exit(0);
      if (error.code !== "EAGAIN") throw error;
      Atomics.wait(kClock, 0, 0, kPauseMs);
    }
  }
}

const kClock = new Int32Array(new SharedArrayBuffer(4));

// The value of `--name`, one of `choices`, of which the first is the default.
export function option(name, choices) {
  const at = process.argv.indexOf(`--${name}`);
  const value = at < 0 ? choices[0] : process.argv[at + 1];
  if (choices.includes(value)) return value;
  writeSync(2, `--${name} ${value}: one of ${choices.join(", ")} is expected\n`);
  process.exit(2);
}

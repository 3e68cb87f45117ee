// How a task is measured under node, as the programs of the other engines are: MODE NUMBERS
//   time BATCHES REPETITIONS   nanoseconds per repetition, a line per batch
//   check REPETITIONS          the result after that many repetitions, one number per line
const WARM_UP_MS = 200;

export function measured(task, mode, [first, second]) {
  task.reset();
  if (mode === 'time') {
    // the host compiles a module again once it has run for a while
    for (const begin = Date.now(); Date.now() - begin < WARM_UP_MS; ) batch(task, second);
    for (let k = 0; k < first; k += 1) console.log(batch(task, second).toFixed(3));
  } else if (mode === 'check') {
    task.repeat(first);
    for (const value of task.result()) console.log(value);
  } else {
    throw new Error(`unknown mode ${mode}`);
  }
}

function batch(task, repetitions) {
  task.reset();
  const begin = process.hrtime.bigint();
  task.repeat(repetitions);
  return Number(process.hrtime.bigint() - begin) / repetitions;
}

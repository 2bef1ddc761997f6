// Runs test files in the given order, each in its own process, with a given number of them in parallel:
//
//   node run-tests.mjs 2 a.test.js b.test.js
//
// `node --test` would sort the files by name: a long file could start last, and all but one core would be idle until it ends.
import { compose } from 'node:stream'
import { run } from 'node:test'
import { spec } from 'node:test/reporters'

/** Max milliseconds per file. No file takes that long, but a file that hangs must fail, so that the results of the others appear. */
const timeout = 15 * 60_000

/** Reports why a file failed although all its tests passed; `spec` only prints "test failed". */
async function* reportReasons(events) {
  const reasons = []
  for await (const { type, data } of events) {
    const { exitCode, signal } = data?.details?.error ?? {}
    if (type === 'test:diagnostic' && /^(Error|Warning): /.test(data.message))
      reasons.push(data.message)
    else if (type === 'test:fail' && (signal ?? exitCode) != null)
      reasons.push(`${data.name} ended with ${signal ?? exitCode}.`)
  }
  if (reasons.length) yield `\nOutside of the tests:\n${reasons.join('\n')}\n`
}

const [concurrency, ...files] = process.argv.slice(2)
const tests = run({ files, concurrency: Number(concurrency), timeout })
tests.on('test:fail', () => (process.exitCode = 1))
for (const reporter of [new spec(), reportReasons]) compose(tests, reporter).pipe(process.stdout)

// Runs test files, each in its own process, a number of them in parallel, in the given order:
//
//   node run-tests.mjs 2 a.test.js b.test.js
//
// `node --test` would sort them by name, so that a long one could start last, and cores would wait for it.
import { compose } from 'node:stream'
import { run } from 'node:test'
import { spec } from 'node:test/reporters'
import whyFailed from './why-failed.mjs'

/** In milliseconds. No file takes as long; a file that hangs must fail rather than hide the results of the others. */
const timeout = 15 * 60_000

const [concurrency, ...files] = process.argv.slice(2)
const tests = run({ files, concurrency: Number(concurrency), timeout })
tests.on('test:fail', () => (process.exitCode = 1))
for (const reporter of [new spec(), whyFailed]) compose(tests, reporter).pipe(process.stdout)

// Runs files of tests, each in a process of its own, so many at once, in the order in which they are named:
//
//   node run-tests.mjs 2 a.test.js b.test.js
//
// `node --test` sorts them by name. Then a long one may begin when most have ended, and cores wait for it.
import { compose } from 'node:stream'
import { run } from 'node:test'
import { spec } from 'node:test/reporters'
import whyFailed from './why-failed.mjs'

/** A file never takes so long; one that hangs is to fail, not to keep all others from being heard of. In milliseconds. */
const timeout = 15 * 60_000

const [concurrency, ...files] = process.argv.slice(2)
const tests = run({ files, concurrency: Number(concurrency), timeout })
tests.on('test:fail', () => (process.exitCode = 1))
for (const reporter of [new spec(), whyFailed]) compose(tests, reporter).pipe(process.stdout)

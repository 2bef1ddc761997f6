// The table of sizes that ends a build, and a warning for each file that grew. No size fails a build.
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import { path } from './files.mjs'
import { good, say } from './terminal.mjs'

/** The gzipped bytes of each file at the last commit that ran `npm run sizes`. */
const committed = '.scripts/sizes.json'

const isGrown = (gzipped, before) => gzipped > 1.05 * before

const kilobytes = (bytes) => `${(bytes / 1024).toFixed(1)} KB`

const measure = (file) => {
  const bytes = readFileSync(path(file))
  return { file, raw: bytes.length, gzipped: gzipSync(bytes, { level: 9 }).length }
}

const readCommitted = () =>
  existsSync(path(committed)) ? JSON.parse(readFileSync(path(committed), 'utf8')) : {}

/** The lines that warn of files more than 5% larger than `before`, an object of gzipped bytes by file. */
export const growthWarnings = (rows, before) =>
  rows
    .filter(({ file, gzipped }) => isGrown(gzipped, before[file] ?? Infinity))
    .map(
      ({ file, gzipped }) =>
        `Warning: ${file} grew by ${((gzipped / before[file] - 1) * 100).toFixed(0)}%, from ${kilobytes(before[file])} to ${kilobytes(gzipped)} gzipped. If that is meant, \`npm run sizes\` records it.`,
    )

/** Prints the size of each file: raw for the disk, gzipped for the network. */
export function reportSizes(files) {
  const rows = files.map(measure)
  const width = Math.max(...files.map((file) => file.length))
  say(`\n${'file'.padEnd(width)} ${'raw'.padStart(11)} ${'gzipped'.padStart(11)}`)
  for (const { file, raw, gzipped } of rows)
    say(`${file.padEnd(width)} ${kilobytes(raw).padStart(11)} ${kilobytes(gzipped).padStart(11)}`)
  growthWarnings(rows, readCommitted()).forEach(say)
}

/** Records the sizes that the next commits are compared with. */
export function recordSizes(files) {
  const sizes = Object.fromEntries(files.map(measure).map(({ file, gzipped }) => [file, gzipped]))
  writeFileSync(path(committed), `${JSON.stringify(sizes, null, 2)}\n`)
  good(`${committed} is up to date`)
}

// Prints the sizes of the files after a build, with a warning for each file that grew. No size fails a build.
import { readFileSync, writeFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import { path, walk } from './files.mjs'
import { good, say } from './terminal.mjs'

/** The gzipped bytes of each file at the last commit that ran `npm run sizes`. */
const sizesFile = '.scripts/sizes.json'

const measureFiles = () =>
  walk('dist', /\.js$/).map((file) => {
    const bytes = readFileSync(path(file))
    return { file, raw: bytes.length, gzipped: gzipSync(bytes, { level: 9 }).length }
  })

/** Returns a warning for each file that is more than 5% larger than in `before`, which maps a file → its gzipped bytes. */
export const growthWarnings = (rows, before) =>
  rows
    .filter(({ file, gzipped }) => gzipped > 1.05 * before[file])
    .map(({ file, gzipped }) => {
      const growth = ((gzipped / before[file] - 1) * 100).toFixed(0)
      return `Warning: ${file} grew by ${growth}%, to ${gzipped} bytes gzipped. If that is intended, \`npm run sizes\` records it.`
    })

/** Prints the size of each file in bytes, raw and gzipped, and the warnings. */
export function reportSizes() {
  const rows = measureFiles()
  console.table(rows)
  growthWarnings(rows, JSON.parse(readFileSync(path(sizesFile), 'utf8'))).forEach((line) =>
    say(line),
  )
}

/** Records the sizes, with which the next builds are compared. */
export function recordSizes() {
  const sizes = Object.fromEntries(measureFiles().map(({ file, gzipped }) => [file, gzipped]))
  writeFileSync(path(sizesFile), `${JSON.stringify(sizes, null, 2)}\n`)
  good(`${sizesFile} is up to date`)
}

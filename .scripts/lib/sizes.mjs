// The table of sizes that ends a build, and a warning for each file that grew. No size fails a build.
import { readFileSync, writeFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import { path, walk } from './files.mjs'
import { good, say } from './terminal.mjs'

/** The gzipped bytes of each file at the last commit that ran `npm run sizes`. */
const recorded = '.scripts/sizes.json'

const measure = () =>
  walk('dist', /\.js$/).map((file) => {
    const bytes = readFileSync(path(file))
    return { file, raw: bytes.length, gzipped: gzipSync(bytes, { level: 9 }).length }
  })

/** The lines that warn of files more than 5% larger than `before`, an object of gzipped bytes by file. */
export const growthWarnings = (rows, before) =>
  rows
    .filter(({ file, gzipped }) => gzipped > 1.05 * before[file])
    .map(({ file, gzipped }) => {
      const growth = ((gzipped / before[file] - 1) * 100).toFixed(0)
      return `Warning: ${file} grew by ${growth}%, to ${gzipped} bytes gzipped. If that is meant, \`npm run sizes\` records it.`
    })

/** Prints the size of each file in bytes: raw for the disk, gzipped for the network. */
export function reportSizes() {
  const rows = measure()
  console.table(rows)
  growthWarnings(rows, JSON.parse(readFileSync(path(recorded), 'utf8'))).forEach((line) =>
    say(line),
  )
}

/** Records the sizes that the next commits are compared with. */
export function recordSizes() {
  const sizes = Object.fromEntries(measure().map(({ file, gzipped }) => [file, gzipped]))
  writeFileSync(path(recorded), `${JSON.stringify(sizes, null, 2)}\n`)
  good(`${recorded} is up to date`)
}

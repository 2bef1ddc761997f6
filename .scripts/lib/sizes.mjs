// The table of sizes that ends a build.
import { readFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import { path } from './files.mjs'
import { say } from './terminal.mjs'

const kilobytes = (bytes) => `${(bytes / 1024).toFixed(1)} KB`

/** Prints what each file weighs: raw for the disk, gzipped for the network. */
export function reportSizes(files) {
  const rows = files.map((file) => {
    const bytes = readFileSync(path(file))
    return { file, raw: bytes.length, gzipped: gzipSync(bytes, { level: 9 }).length }
  })
  const width = Math.max(...files.map((file) => file.length))
  say(`\n${'file'.padEnd(width)} ${'raw'.padStart(11)} ${'gzipped'.padStart(11)}`)
  for (const { file, raw, gzipped } of rows)
    say(`${file.padEnd(width)} ${kilobytes(raw).padStart(11)} ${kilobytes(gzipped).padStart(11)}`)
}

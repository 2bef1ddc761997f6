// The table of sizes that ends a build, and the limits that it keeps.
import { readFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import { path } from './files.mjs'
import { Stop, say } from './terminal.mjs'

const kilobytes = (bytes) => `${(bytes / 1024).toFixed(1)} KB`

/** The most bytes that a file may have when gzipped: what a page with p5, itself 280 KB, waits for. */
const limits = {
  'dist/p5.warpjet.min.js': 169.5 * 1024,
  'dist/p5.warpjet.slim.min.js': 129.8 * 1024,
  'dist/warpjet.glsl.min.js': 91 * 1024,
  'dist/warpjet.operators.min.js': 40 * 1024,
}

export function reportSizes(files) {
  const rows = files.map((file) => {
    const bytes = readFileSync(path(file))
    const gzipped = gzipSync(bytes, { level: 9 }).length
    return { file, raw: bytes.length, gzipped, limit: limits[file] }
  })
  const width = Math.max(...files.map((file) => file.length))
  say(`\n${'file'.padEnd(width)} ${'raw'.padStart(11)} ${'gzipped'.padStart(11)}`)
  for (const { file, raw, gzipped, limit } of rows) {
    const note = limit ? `  (limit ${kilobytes(limit)})` : ''
    say(
      `${file.padEnd(width)} ${kilobytes(raw).padStart(11)} ${kilobytes(gzipped).padStart(11)}${note}`,
    )
  }
  for (const { file, gzipped, limit } of rows)
    if (gzipped > limit) throw new Stop(`${file} is ${gzipped - limit} bytes over its limit`)
}

// The budgets of three pages of the site: the bytes and requests before a visitor can use them.
import { existsSync, readFileSync } from 'node:fs'
import { dirname, join } from 'node:path/posix'
import { gzipSync } from 'node:zlib'
import { parse } from 'acorn'
import { path, walk } from './files.mjs'
import { Stop, say } from './terminal.mjs'

/** `bytes` are compressed; `requests` include the page itself. Pictures further down load lazily. */
const budgets = {
  'index.html': { bytes: 60_000, requests: 10 },
  'docs/tutorial-1-first-warp.html': { bytes: 40_000, requests: 8 },
  'gallery/sine-sphere/index.html': { bytes: 60_000, requests: 11 },
}

const compressible = /\.(?:html|css|js|json|svg)$/

/** Returns the bytes of a file, compressed if servers compress such files. */
const measureFile = (file) => {
  const bytes = readFileSync(path(file))
  return compressible.test(file) ? gzipSync(bytes, { level: 9 }).length : bytes.length
}

/** Lists the modules that a script imports statically. */
function listImports(text) {
  const { body } = parse(text, { ecmaVersion: 'latest', sourceType: 'module' })
  return body.map(({ source }) => source?.value).filter((url) => url?.startsWith('.'))
}

/** Lists the URLs that a file loads at once, without links to other pages and lazy images. */
function listUrls(file, text) {
  const tags = [...text.matchAll(/<(?:script|link|img)\b[^>]*>/g)].map(([tag]) => tag)
  const early = tags.filter((tag) => !/loading="lazy"/.test(tag))
  return [
    ...early.map((tag) => /(?:src|href)="([^"]+)"/.exec(tag)?.[1]),
    ...[...text.matchAll(/\burl\('([^']+)'\)/g)].map(([, url]) => url),
    ...(file.endsWith('.js') ? listImports(text) : []),
  ].filter((url) => url && !url.startsWith('data:') && !url.startsWith('http'))
}

/** Lists the files of `folder` that the page at `start` loads at once. */
export function listFiles(folder, start) {
  const files = new Set([start])
  for (const file of files) {
    if (!compressible.test(file)) continue
    const text = readFileSync(path(folder, file), 'utf8')
    for (const url of listUrls(file, text)) {
      const target = join(dirname(file), url.split(/[?#]/)[0])
      if (existsSync(path(folder, target))) files.add(target)
      else throw new Stop(`${folder}/${file} refers to ${url}, which does not exist.`)
    }
  }
  return [...files]
}

/** Prints the sizes of the pages; throws if one exceeds its budget. */
export function checkSite(folder) {
  const overBudget = []
  for (const [page, { bytes, requests }] of Object.entries(budgets)) {
    const files = listFiles(folder, page)
    const total = files.reduce((sum, file) => sum + measureFile(join(folder, file)), 0)
    say(
      `${page.padEnd(34)} ${(total / 1000).toFixed(1)} KB of ${bytes / 1000}, ${files.length} requests of ${requests}`,
    )
    if (total > bytes || files.length > requests) overBudget.push(page)
  }
  const all = walk(folder)
  const siteSize = all.reduce((sum, file) => sum + readFileSync(path(file)).length, 0)
  say(`the whole site                     ${(siteSize / 1e6).toFixed(1)} MB, ${all.length} files`)
  if (overBudget.length) throw new Stop(`Over budget: ${overBudget.join(', ')}.`)
}

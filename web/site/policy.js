/** Adds a Content-Security-Policy to a page as a meta tag, because the host of a static site may not let it set headers. */
import { createHash } from 'node:crypto'

const common = {
  'default-src': "'none'",
  'style-src': "'self' 'unsafe-inline'",
  'img-src': "'self' data: blob:",
  'media-src': "'self' blob:",
  'font-src': "'self' data:",
  'connect-src': "'self' data: blob:",
  'worker-src': "'self'",
  'frame-src': "'self'",
  'base-uri': "'none'",
  'form-action': "'self'",
}

/**
 * `page` is for the site's own pages, `sketch` for examples with p5 and three.js: p5.strands and warpjet's operators evaluate code
 * from strings, and the gallery runs a changed sketch from a blob.
 */
const scripts = { page: "'self' 'wasm-unsafe-eval'", sketch: "'self' 'unsafe-eval' blob:" }

const hashOf = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`

/** Returns the contents of inline scripts, without JSON. */
const inlineScripts = (html) =>
  [...html.matchAll(/<script\b([^>]*)>([^]*?)<\/script>/g)]
    .filter(([, attributes]) => !/\bsrc=|application\/json/.test(attributes))
    .map(([, , text]) => text)

/** Adds a policy that allows the page's inline scripts and no others. */
export function withPolicy(html, kind = 'page') {
  const hashes = [...new Set(inlineScripts(html).map(hashOf))]
  const policy = { ...common, 'script-src': [scripts[kind], ...hashes].join(' ') }
  const content = Object.entries(policy)
    .map(([name, value]) => `${name} ${value}`)
    .join('; ')
  const tag = `<meta http-equiv="Content-Security-Policy" content="${content}" />`
  return html.replace(/<meta charset="utf-8"[^>]*>/i, (charset) => `${charset}\n    ${tag}`)
}

/** Vite plugin: adds the policy to pages that are HTML files. */
export const policies = () => ({
  name: 'policies',
  transformIndexHtml: { order: 'post', handler: (html) => withPolicy(html) },
})

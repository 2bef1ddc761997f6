// npm run report -- derivatives | noise | normals | subdivision | uptime: measures warpjet, and writes the figures into that page of web/docs.
import { writeFileSync } from 'node:fs'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { Stop, good, main, seconds } from './lib/terminal.mjs'
import { pageWith } from './reference/parts.mjs'
import { setup } from './setup.mjs'

const names = ['derivatives', 'noise', 'normals', 'subdivision', 'uptime']

await main(async () => {
  const [name] = process.argv.slice(2)
  if (!names.includes(name)) throw new Stop(`Expected one of ${names.join(', ')}, got ${name}.`)
  process.env.WARPJET_CHROMIUM = (await setup()).chromium
  await build()
  const start = performance.now()
  const { measure } = await import(`./report/${name}.mjs`)
  const file = `web/docs/${name}.md`
  writeFileSync(path(file), await pageWith(file, await measure()))
  good(`${file}: ${seconds(start)}`)
})

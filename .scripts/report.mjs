// npm run report -- NAME: measures warpjet, and writes the figures into web/docs/NAME.md. A name is a file of .scripts/report.
import { readdirSync, writeFileSync } from 'node:fs'
import { build } from './build.mjs'
import { path } from './lib/files.mjs'
import { Stop, good, main, seconds } from './lib/terminal.mjs'
import { replaceParts } from './reference/parts.mjs'
import { setup } from './setup.mjs'

await main(async () => {
  const [name] = process.argv.slice(2)
  const names = readdirSync(path('.scripts/report'))
    .filter((file) => file.endsWith('.mjs'))
    .map((file) => file.replace('.mjs', ''))
  if (!names.includes(name)) throw new Stop(`Expected one of ${names.join(', ')}, got ${name}.`)
  process.env.WARPJET_CHROMIUM = (await setup()).chromium
  await build()
  const start = performance.now()
  const { measure } = await import(`./report/${name}.mjs`)
  const file = `web/docs/${name}.md`
  writeFileSync(path(file), await replaceParts(file, await measure()))
  good(`${file}: ${seconds(start)}`)
})

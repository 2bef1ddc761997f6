// npm test: set-up, build, then every check; `npm test -- js cpp` runs only those groups. Nothing stops at a failure.
import { build } from './build.mjs'
import { checks } from './lib/checks.mjs'
import { Stop, bad, good, heading, main, say, seconds } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

await main(async () => {
  const chosen = select(process.argv.slice(2))
  const { chromium } = await setup()
  process.env.WARPJET_CHROMIUM = chromium

  const results = [await attempt({ title: 'Build', work: build })]
  for (const check of chosen) results.push(await attempt(check))

  heading('Summary')
  for (const { title, passed, time } of results) (passed ? good : bad)(`${title} (${time})`)
  const failed = results.filter(({ passed }) => !passed).length
  if (failed) throw new Stop(`${failed} of ${results.length} steps failed.`)
  good('Everything passed.')
})

function select(groups) {
  const known = [...new Set(checks.map(({ group }) => group))]
  const unknown = groups.find((group) => !known.includes(group))
  if (unknown)
    throw new Stop(`There are no tests named ${unknown}: choose from ${known.join(', ')}.`)
  return groups.length ? checks.filter(({ group }) => groups.includes(group)) : checks
}

async function attempt({ title, work }) {
  heading(title)
  const start = performance.now()
  let passed = true
  try {
    await work()
  } catch (error) {
    bad(error instanceof Stop ? error.message : error.stack)
    passed = false
  }
  const time = seconds(start)
  say(`${title}: ${passed ? 'passed' : 'FAILED'} in ${time}`)
  return { title, passed, time }
}

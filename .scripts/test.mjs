// npm test: set-up, build, then the everyday checks; `npm test -- --all` runs every check. `npm test -- js cpp` runs only those groups.
// A failure does not stop the other steps.
import { parseArgs } from 'node:util'
import { build } from './build.mjs'
import { checks } from './lib/checks.mjs'
import { NotRun, Stop, bad, good, heading, main, say } from './lib/terminal.mjs'
import { chooseTier, limits, rareSteps } from './lib/tiers.mjs'
import { printTimes } from './lib/times.mjs'
import { setup } from './setup.mjs'

await main(async () => {
  const start = performance.now()
  const { groups, tier } = options()
  const chosen = select(groups, tier)
  chooseTier(tier)
  const results = []
  const record = async (step) => results.push(await attempt(step))

  await record({
    title: 'Set-up',
    work: async () => (process.env.WARPJET_CHROMIUM = (await setup()).chromium),
  })
  if (!results[0].passed) throw new Stop('Nothing can be tested without that.')
  await record({ title: 'Build', work: build })
  for (const check of chosen) await record(check)

  heading(tier === 'all' ? 'Everything' : 'The everyday run; `npm test -- --all` is everything')
  printTimes(results, performance.now() - start, groups.length ? null : limits[tier])
  const failed = results.filter(({ passed }) => !passed)
  for (const { title, why } of failed) bad(`${title}: ${why}`)
  if (failed.length) throw new Stop(`Failed: ${failed.length} of ${results.length} steps.`)
  const notRun = results.filter(({ notRun }) => notRun)
  if (notRun.length)
    say(`What was run passed; NOT RUN: ${notRun.map(({ title }) => title).join(', ')}.`)
  else good('Everything passed.')
})

function options() {
  const known = [...new Set(checks.map(({ group }) => group))]
  try {
    const { values, positionals } = parseArgs({
      options: { all: { type: 'boolean' } },
      allowPositionals: true,
    })
    const unknown = positionals.find((group) => !known.includes(group))
    if (unknown) throw new Error(`There are no tests named ${unknown}.`)
    return { groups: positionals, tier: values.all ? 'all' : 'everyday' }
  } catch ({ message }) {
    throw new Stop(`${message}\n\nnpm test -- [--all] [${known.join('] [')}]`)
  }
}

function select(groups, tier) {
  const chosen = checks.filter(({ group }) => !groups.length || groups.includes(group))
  const run = chosen.filter(({ title }) => tier === 'all' || !(title in rareSteps))
  const reasons = chosen.map(({ title }) => `${title}: ${rareSteps[title]}`)
  if (!run.length)
    throw new Stop(`Nothing of that is run every day; add --all.\n${reasons.join('\n')}`)
  return run
}

async function attempt({ title, work }) {
  heading(title)
  const start = performance.now()
  let why
  let notRun
  try {
    await work()
  } catch (error) {
    if (error instanceof NotRun) notRun = error.message
    else bad((why = error instanceof Stop ? error.message : (error?.stack ?? String(error))))
  }
  const time = performance.now() - start
  const passed = why === undefined
  if (!passed) say(`${title}: FAILED`)
  if (notRun) say(`${title}: NOT RUN: ${notRun}`)
  return { title, passed, why, notRun, time }
}

// npm test: sets up, builds, and runs the everyday checks; `npm test -- --all` runs every check, `npm test -- js cpp` only those groups.
// A failure does not stop the other steps, except a failure of the set-up.
import { parseArgs } from 'node:util'
import { build } from './build.mjs'
import { checks } from './lib/checks.mjs'
import { NotRun, Stop, bad, good, heading, main, say, seconds } from './lib/terminal.mjs'
import { chooseTier } from './lib/tiers.mjs'
import { setup } from './setup.mjs'

const groupNames = [...new Set(checks.map(({ group }) => group))]
const usage = `\n\nnpm test -- [--all] [${groupNames.join('] [')}]`

await main(async () => {
  const start = performance.now()
  const { values, positionals: groups } = parseArgs({
    options: { all: { type: 'boolean' } },
    allowPositionals: true,
  })
  const chosen = selectChecks(groups, values.all)
  chooseTier(values.all ? 'all' : 'everyday')
  const results = []
  const record = async (step) => results.push(await attempt(step))

  await record({
    title: 'Set-up',
    work: async () => (process.env.WARPJET_CHROMIUM = (await setup()).chromium),
  })
  if (results[0].result !== 'passed') throw new Stop('Nothing can be tested without the set-up.')
  await record({ title: 'Build', work: build })
  for (const check of chosen) await record(check)

  heading(values.all ? 'Everything' : 'The everyday run; `npm test -- --all` is everything')
  console.table(results, ['step', 'time', 'result'])
  const withResult = (wanted) => results.filter(({ result }) => result === wanted)
  for (const { step, why } of [...withResult('FAILED'), ...withResult('NOT RUN')])
    bad(`${step}: ${why}`)
  say(`In all ${seconds(start)}`)
  if (withResult('FAILED').length)
    throw new Stop(`Failed: ${withResult('FAILED').length} of ${results.length} steps.`)
  if (!withResult('NOT RUN').length) good('Everything passed.')
}, usage)

function selectChecks(groups, isAll) {
  const unknown = groups.find((group) => !groupNames.includes(group))
  if (unknown) throw new Stop(`There are no tests named ${unknown}.${usage}`)
  const chosen = checks.filter(({ group }) => !groups.length || groups.includes(group))
  const checksToRun = chosen.filter(({ rare }) => isAll || !rare)
  const reasons = chosen.map(({ title, rare }) => `${title}: ${rare}`)
  if (!checksToRun.length)
    throw new Stop(
      `The everyday run includes none of these steps; add --all.\n${reasons.join('\n')}`,
    )
  return checksToRun
}

async function attempt({ title: step, work }) {
  heading(step)
  const start = performance.now()
  const createResult = (result, why) => ({ step, time: seconds(start), result, why })
  try {
    await work()
    return createResult('passed')
  } catch (error) {
    const why = error instanceof Stop ? error.message : (error?.stack ?? String(error))
    if (error instanceof NotRun) return createResult('NOT RUN', error.message)
    bad(`${step}: ${why}`)
    return createResult('FAILED', why)
  }
}

// npm run fuzz: gives the fuzz targets of tests/fuzz new bytes for a time, under the sanitizers. What reached new places in
// the code is kept in .build/fuzz/corpus, so that the next run goes on from there.
import { spawn } from 'node:child_process'
import { createWriteStream, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { createInterface } from 'node:readline'
import { parseArgs } from 'node:util'
import { cmakeBuild } from './lib/cmake.mjs'
import { path, walk } from './lib/files.mjs'
import { capture, run } from './lib/run.mjs'
import { Stop, good, heading, isMain, main, say } from './lib/terminal.mjs'
import { setup } from './setup.mjs'
import { own } from '../tests/glsl/own.js'

const programs = '.build/sanitize'
const folder = '.build/fuzz'
const seeds = 'tests/fuzz/corpus'

/**
 * By name, what libFuzzer is told: the longest input, in bytes, and the words of the format. `runs` is how many inputs
 * the tests give it, about as many as it takes in 20 s beside the others on two cores.
 */
const targets = {
  mesh: { args: ['-max_len=8192', '-dict=tests/fuzz/gltf.dict'], runs: 14_000 },
  graph: { args: ['-max_len=1024'], runs: 1_200 },
  glsl: { args: ['-max_len=4096', '-dict=tests/fuzz/glsl.dict'], runs: 110_000 },
}

// One input may take 2 GB, and ask for 1.5 GB at once: the largest mesh that a file may claim has 1.
const limits = ['-rss_limit_mb=2048', '-malloc_limit_mb=1536', '-print_final_stats=1']

/**
 * Runs the targets at once for some seconds, with other random numbers each time, and goes on from what earlier runs kept.
 * An input that takes more than 10 s is a finding.
 */
export const fuzz = (seconds, names = Object.keys(targets)) =>
  runTargets(names, (name) => ({
    corpus: `${folder}/corpus/${name}`,
    args: [`-max_total_time=${seconds}`, '-timeout=10'],
  }))

/**
 * For the tests: the same inputs each time, so that what it finds is no matter of luck. Addresses, which decide a branch
 * here and there, stay where they are if the system lets them; of comparisons, some of them of addresses, libFuzzer learns
 * nothing, nor does it read its folder again when the clock says so. What takes two minutes never ends.
 */
export async function fuzzRepeatably() {
  const isAllowed = (await capture('setarch', ['-R', 'true'])) !== null
  await runTargets(Object.keys(targets), (name) => {
    const corpus = `${folder}/scratch/${name}`
    rmSync(path(corpus), { recursive: true, force: true })
    return {
      corpus,
      args: ['-seed=1', '-use_cmp=0', '-reload=0', `-runs=${targets[name].runs}`, '-timeout=120'],
      by: isAllowed ? ['setarch', '-R'] : [],
    }
  })
}

async function runTargets(names, searchOf) {
  await cmakeBuild('sanitize', ...names.map((name) => `${name}_fuzz`))
  const results = await Promise.all(names.map((name) => runTarget(name, searchOf(name))))
  const problems = results.filter(Boolean)
  if (problems.length) throw new Stop(problems.join('\n'))
}

/** A sentence if it found something, with the bytes: the machine that found them may be out of reach. */
async function runTarget(name, { corpus, args: search, by = [] }) {
  const findings = `${folder}/findings`
  for (const needed of [corpus, findings]) mkdirSync(path(needed), { recursive: true })

  const program = `${programs}/${name}_fuzz`
  const log = `${findings}/${name}.log`
  const told = [
    ...search,
    ...limits,
    `-artifact_prefix=${findings}/${name}-`,
    ...targets[name].args,
  ]
  const [command, ...args] = [...by, path(program), corpus, `${seeds}/${name}`, ...told]
  const { code, progress, reason, input } = await follow(
    name,
    spawn(command, args, { cwd: path(), stdio: ['ignore', 'ignore', 'pipe'] }),
    createWriteStream(path(log)),
  )
  if (code === 0) {
    good(`${name}: ${progress}; nothing found`)
    return null
  }
  const why = reason ?? `it ended with ${code}`
  if (!input) return `${name}: ${why}; see ${log}.`
  const bytes = readFileSync(path(input)).toString('base64')
  return `${name}: ${why}; see ${log}, and run it again with: ${program} ${input}
Its bytes in base64: ${bytes}`
}

// What the sanitizers, the standard library, libFuzzer and tests/fuzz/require.hpp say of a finding.
const reasons = [
  /^NOT TRUE: (.*)/,
  /runtime error: (.*)/,
  /: (Assertion .* failed)\.$/,
  /^terminate called after (throwing .*)/,
  /^=*\d+=+ ?ERROR: (.*)/,
]

/** Says every ten seconds how far it is. */
async function follow(name, child, log) {
  const ended = new Promise((resolve) => {
    child.on('error', (error) => resolve(error.code))
    child.on('close', (code, signal) => resolve(code ?? signal))
  })
  let progress = 'no runs'
  let reason
  let input
  let next = performance.now() + 10_000
  for await (const line of createInterface(child.stderr)) {
    log.write(`${line}\n`)
    reason ??= reasons.map((pattern) => line.match(pattern)?.[1]).find(Boolean)
    input ??= line.match(/Test unit written to (.*)/)?.[1]
    const [, runs, places] = line.match(/^#(\d+)\s.*\bcov: (\d+)/) ?? []
    if (runs) progress = `${count(runs)} runs, ${count(places)} edges of the code covered`
    if (runs && performance.now() > next) {
      say(`${name}: ${progress}`)
      next = performance.now() + 10_000
    }
  }
  log.end()
  return { code: await ended, progress, reason, input }
}

const count = (text) => Number(text).toLocaleString('en')

/** Writes the seeds of tests/fuzz/corpus anew; what fuzzing once found stays beside them. */
async function writeSeeds() {
  await cmakeBuild('sanitize', 'fuzz_seeds')
  await run(path(programs, 'fuzz_seeds'), [seeds])
  mkdirSync(path(seeds, 'glsl'), { recursive: true })
  const texts = { ...own, 'a misspelled function': 'float own(float x) { return exAp2(x); }' }
  for (const [name, text] of Object.entries(texts))
    writeFileSync(path(seeds, 'glsl', slug(name)), text.replaceAll('\n  ', '\n') + '\n')
  good(`${walk(seeds).length} files in ${seeds}`)
}

const slug = (name) => name.toLowerCase().replaceAll(/\W+/g, '-')

const help = `npm run fuzz -- [--seconds 60] [--target ${Object.keys(targets).join('|')}] [--seeds]

  --seconds  how long each target runs; 60 by default
  --target   only this one; otherwise all at once
  --seeds    writes the seeds in ${seeds} anew, from tests/fuzz/*_seeds.cpp and tests/glsl/own.js, and ends`

function options() {
  try {
    const { values } = parseArgs({
      options: {
        seconds: { type: 'string', default: '60' },
        target: { type: 'string' },
        seeds: { type: 'boolean' },
        help: { type: 'boolean' },
      },
    })
    return values
  } catch (error) {
    throw new Stop(`${error.message}\n\n${help}`)
  }
}

async function start() {
  const { seconds, target, seeds: writes, help: asks } = options()
  if (asks) return say(help)
  if (!(Number(seconds) >= 1 && Number.isInteger(Number(seconds))))
    throw new Stop(`--seconds must be a whole number from 1 up, but is ${seconds}.`)
  if (target !== undefined && !targets[target])
    throw new Stop(`There is no target ${target}: choose from ${Object.keys(targets).join(', ')}.`)
  await setup()
  if (writes) return writeSeeds()
  heading(`Fuzzing for ${seconds} s`)
  await fuzz(Number(seconds), target ? [target] : undefined)
}

if (isMain(import.meta)) await main(start)

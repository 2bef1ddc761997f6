// npm run fuzz: feeds new bytes to the fuzz targets of tests/fuzz for a given time, under sanitizers. Inputs that reach new code are
// stored in .build/fuzz/corpus, and the next run continues from them. `npm test -- --all` starts its search from scratch each time.
import { spawn } from 'node:child_process'
import { existsSync, mkdirSync, openSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { ownFunctions } from '../tests/glsl/own.js'
import { blocks, values } from '../tests/glsl/values.js'
import { ownFunctions as ownWgslFunctions } from '../tests/wgsl/own.js'
import { cmakeBuild } from './lib/cmake.mjs'
import { path, walk } from './lib/files.mjs'
import { parseOptions } from './lib/options.mjs'
import { capture, run } from './lib/run.mjs'
import { Stop, good, heading, isMain, main, say } from './lib/terminal.mjs'
import { setup } from './setup.mjs'

const programs = '.build/sanitize'
const folder = '.build/fuzz'
const findings = `${folder}/findings`
const seeds = 'tests/fuzz/corpus'

/**
 * Maps each target → libFuzzer's options (the max length of an input in bytes, and the dictionary of the format) and `runs`, the
 * number of inputs of a repeatable search. All four targets together take about 20 s on two cores.
 */
const targets = {
  mesh: { args: ['-max_len=8192', '-dict=tests/fuzz/gltf.dict'], runs: 14_000 },
  graph: { args: ['-max_len=1024'], runs: 1_200 },
  glsl: { args: ['-max_len=4096', '-dict=tests/fuzz/glsl.dict'], runs: 110_000 },
  wgsl: { args: ['-max_len=4096', '-dict=tests/fuzz/wgsl.dict'], runs: 110_000 },
}

// One input may take 10 s and 2 GB in total, and allocate 1.5 GB at once: the largest mesh that a file can declare takes 1 GB.
const limits = ['-timeout=10', '-rss_limit_mb=2048', '-malloc_limit_mb=1536']

/**
 * Runs the same inputs each time, so that failures are reproducible. Turns off random addresses (where the system allows it), learning
 * from compared values (some of which are addresses), and rereading the corpus at time intervals.
 */
export async function fuzzRepeatably() {
  rmSync(path(folder, 'scratch'), { recursive: true, force: true })
  const canFixAddresses = (await capture('setarch', ['-R', 'true'])) !== null
  if (!canFixAddresses)
    say('Addresses are randomized on this system, so the inputs differ slightly from run to run.')
  await runTargets(
    Object.keys(targets),
    'scratch',
    ({ runs }) => ['-seed=1', '-use_cmp=0', '-reload=0', `-runs=${runs}`],
    canFixAddresses ? ['setarch', '-R'] : [],
  )
}

/**
 * Runs targets in parallel, and stores new inputs in the folder `corpus` of .build/fuzz. `searchOptions` returns libFuzzer's options for a
 * target; `launcher` is a command line that starts the target's program.
 */
async function runTargets(names, corpus, searchOptions, launcher = []) {
  await cmakeBuild('sanitize', ...names.map((name) => `${name}_fuzz`))
  const results = await Promise.all(
    names.map((name) =>
      runTarget(name, `${folder}/${corpus}/${name}`, searchOptions(targets[name]), launcher),
    ),
  )
  const problems = results.filter(Boolean)
  if (problems.length) throw new Stop(problems.join('\n'))
}

/**
 * Runs one target. Returns a message if the target found something, otherwise null. The message contains the bytes of the input, since the
 * machine on which the target ran may be inaccessible.
 */
async function runTarget(name, corpusFolder, searchOptions, launcher) {
  for (const directory of [corpusFolder, findings]) mkdirSync(path(directory), { recursive: true })
  const program = `${programs}/${name}_fuzz`
  const log = `${findings}/${name}.log`
  // Lists the seeds in order, because the order of files in a folder depends on the file system.
  const seedInputs = `-seed_inputs=${walk(`${seeds}/${name}`).join(',')}`
  const options = [
    seedInputs,
    ...searchOptions,
    ...limits,
    ...targets[name].args,
    '-print_final_stats=1',
  ]
  const [command, ...args] = [...launcher, path(program), corpusFolder, ...options]
  const child = spawn(command, [...args, `-artifact_prefix=${findings}/${name}-`], {
    cwd: path(),
    stdio: ['ignore', 'ignore', openSync(path(log), 'w')],
  })
  const code = await new Promise((resolve) => {
    child.on('error', (error) => resolve(error.code))
    child.on('close', (code, signal) => resolve(code ?? signal))
  })
  const text = readFileSync(path(log), 'utf8')
  if (code === 0) {
    const [, runs, edges] = [...text.matchAll(/^#(\d+)\s.*\bcov: (\d+)/gm)].at(-1)
    good(`${name}: ${runs} runs, ${edges} edges of the code covered; nothing found`)
    return null
  }
  // Matches the messages of sanitizers, standard library, libFuzzer and tests/fuzz/require.hpp.
  const reason = /^.*(?:NOT TRUE: |runtime error: |Assertion .* failed|terminate called|ERROR: ).*/m
  const why = `${name}: ${reason.exec(text)?.[0] ?? `it ended with ${code}`}; see ${log}`
  const [, input] = /Test unit written to (.*-(?:crash|leak|oom|timeout)-.*)/.exec(text) ?? []
  if (!input || !existsSync(path(input))) return `${why}.`
  const bytes = readFileSync(path(input)).toString('base64')
  return `${why}, and run it again with: ${[program, ...limits, input].join(' ')}\nIts bytes in base64: ${bytes}`
}

/** Rewrites the seeds in tests/fuzz/corpus. The inputs that fuzzing found, which are in the same folder, stay. */
async function writeSeeds() {
  await cmakeBuild('sanitize', 'fuzz_seeds')
  await run(path(programs, 'fuzz_seeds'), [seeds])
  const glslSources = {
    ...ownFunctions,
    ...values[300],
    ...Object.fromEntries(
      Object.entries(blocks).map(([name, parts]) => [`a block ${name}`, parts.join('\n')]),
    ),
    'a misspelled function': 'float own(float x) { return exAp2(x); }',
  }
  for (const [language, sources] of Object.entries({ glsl: glslSources, wgsl: ownWgslFunctions })) {
    mkdirSync(path(seeds, language), { recursive: true })
    for (const [name, text] of Object.entries(sources))
      writeFileSync(path(seeds, language, toFileName(name)), text.replaceAll('\n  ', '\n') + '\n')
  }
  good(`${walk(seeds).length} files in ${seeds}`)
}

const toFileName = (name) => name.toLowerCase().replaceAll(/\W+/g, '-')

const usage = `
npm run fuzz -- [--seconds 60] [--target ${Object.keys(targets).join('|')}] [--seeds]

  --seconds  how long each target runs. Default: 60
  --target   the only target to run. Default: all at once
  --seeds    rewrites the seeds in ${seeds} from tests/fuzz/*_seeds.cpp, tests/glsl and tests/wgsl, and exits`

if (isMain(import.meta))
  await main(async () => {
    const {
      seconds,
      target,
      seeds: isSeeding,
    } = parseOptions(
      process.argv.slice(2),
      { seconds: 60 },
      { target: { type: 'string' }, seeds: { type: 'boolean' } },
    )
    if (target !== undefined && !targets[target])
      throw new Stop(
        `Expected one of the targets ${Object.keys(targets).join(', ')}, got ${target}.`,
      )
    await setup()
    if (isSeeding) return writeSeeds()
    heading(`Fuzzing for ${seconds} s`)
    const names = target ? [target] : Object.keys(targets)
    return runTargets(names, 'corpus', () => [`-max_total_time=${seconds}`])
  }, usage)

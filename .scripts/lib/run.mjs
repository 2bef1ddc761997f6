// Child processes: `run` shows what the program prints, `capture` returns it.
import { spawn } from 'node:child_process'
import { basename } from 'node:path'
import { Stop, root } from './terminal.mjs'

/** Runs a program and shows its output. Throws a Stop unless it exits with 0. */
export async function run(command, args, options = {}) {
  const code = await exitCode(command, args, options)
  if (code !== 0) throw new Stop(`${basename(command)} ${args[0] ?? ''} failed (${code})`)
}

/** Runs a program and returns its exit status, the signal that ended it, or the error's code. `timeout` is in milliseconds. */
export function exitCode(command, args, { env = {}, cwd = root, timeout } = {}) {
  const options = { cwd, env: { ...process.env, ...env }, stdio: 'inherit', timeout }
  const child = spawn(command, args, options)
  return new Promise((resolve) => {
    child.on('error', (error) => resolve(error.code))
    child.on('close', (code, signal) => resolve(code ?? signal))
  })
}

/** Runs a program and returns its stdout, or null if it cannot be started, fails, or exceeds `timeout` milliseconds. */
export function capture(command, args, { env = {}, timeout } = {}) {
  const child = spawn(command, args, {
    cwd: root,
    env: { ...process.env, ...env },
    stdio: ['ignore', 'pipe', 'ignore'],
    timeout,
  })
  let text = ''
  child.stdout.setEncoding('utf8').on('data', (part) => (text += part))
  return new Promise((resolve) => {
    child.on('error', () => resolve(null))
    child.on('close', (code) => resolve(code === 0 ? text : null))
  })
}

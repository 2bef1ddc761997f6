// Builds with Vite, isolated from a Vite server in the same process.
import { Stop } from './terminal.mjs'

/**
 * Builds each config in turn. If NODE_ENV is unset, Vite sets it for its process and its child processes: a build that follows a server
 * would be a development build, and a server that follows a build would serve its pages in production mode. So NODE_ENV is unset for the
 * builds, and restored after them.
 * Throws the Stop of a plugin as it is.
 */
export async function viteBuild(...configs) {
  const { build } = await import('vite')
  const { NODE_ENV } = process.env
  delete process.env.NODE_ENV
  try {
    for (const config of configs) await build(config)
  } catch (error) {
    // Vite wraps what a plugin throws.
    throw error.errors?.find((each) => each instanceof Stop) ?? error
  } finally {
    if (NODE_ENV === undefined) delete process.env.NODE_ENV
    else process.env.NODE_ENV = NODE_ENV
  }
}

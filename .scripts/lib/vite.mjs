// Builds with Vite, isolated from a Vite server in the same process.

/**
 * Builds each config in turn. Vite sets NODE_ENV for its process and child processes if it is unset: after a server, a build would be a
 * development build, and after a build, a server would serve its pages in production mode.
 */
export async function viteBuild(...configs) {
  const { build } = await import('vite')
  const { NODE_ENV } = process.env
  delete process.env.NODE_ENV
  try {
    for (const config of configs) await build(config)
  } finally {
    if (NODE_ENV === undefined) delete process.env.NODE_ENV
    else process.env.NODE_ENV = NODE_ENV
  }
}

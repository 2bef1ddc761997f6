// Vite's builds, with nothing of what a server in the same process has set, and without what they leave behind.

/**
 * Builds each config in turn. Vite sets NODE_ENV for its process and all that this one starts, unless it is set: a build would
 * be one for development after a server, and a server that is begun after a build would take its pages for built ones.
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

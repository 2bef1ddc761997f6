// The command-line flags of headless Chromium, for tests and benchmarks.

const commonFlags = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--ignore-gpu-blocklist',
]

/** Renders WebGL in software, with the same result on every machine. */
export const softwareFlags = [
  ...commonFlags,
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
]

/** Composites pages on the CPU: compositing through software WebGL would cost as much again as drawing the canvases. */
export const testFlags = [...softwareFlags, '--disable-gpu-compositing']

/**
 * WebGL on the machine's GPU. On Linux, Chromium without a display finds a GPU only through Vulkan; elsewhere its default works.
 * Without a GPU, Chromium may fall back to software or have no WebGL: check the renderer's name.
 */
export const gpuFlags = [
  ...commonFlags,
  ...(process.platform === 'linux'
    ? ['--use-angle=vulkan', '--enable-features=Vulkan', '--disable-vulkan-surface']
    : []),
]

/** Frames without a rate limit, and exact memory sizes. */
export const uncappedFlags = [
  '--disable-frame-rate-limit',
  '--disable-gpu-vsync',
  '--enable-precise-memory-info',
]

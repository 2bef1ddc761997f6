// How a headless Chromium is started, by the tests and by the benchmark: the flags of its command line.

const quiet = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--ignore-gpu-blocklist',
]

/** WebGL without a GPU, the same on every machine. */
export const softwareFlags = [...quiet, '--use-angle=swiftshader', '--enable-unsafe-swiftshader']

/** Pages are put together on the CPU: through a WebGL that is one itself, that would cost as much again as what the canvases show. */
export const testFlags = [...softwareFlags, '--disable-gpu-compositing']

/**
 * WebGL on the machine's GPU. On Linux, Chromium without a display finds one by Vulkan alone; elsewhere its own choice is right.
 * Where there is none, Chromium may draw without, or have no WebGL: the renderer's name tells.
 */
export const gpuFlags = [
  ...quiet,
  ...(process.platform === 'linux'
    ? ['--use-angle=vulkan', '--enable-features=Vulkan', '--disable-vulkan-surface']
    : []),
]

/** Frames as fast as they can be drawn, and memory to the byte. */
export const uncappedFlags = [
  '--disable-frame-rate-limit',
  '--disable-gpu-vsync',
  '--enable-precise-memory-info',
]

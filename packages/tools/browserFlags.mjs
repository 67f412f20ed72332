/**
 * Flags of headless Chromium for tests and screenshots: WebGL2 on the software rasteriser, so that every machine draws
 * the same picture, and no traffic of the browser's own.
 *
 * @type {readonly string[]}
 */
export const softwareFlags = [
  '--headless=new',
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-gpu-rasterization',
  // else each program has a pipeline cache of its own, and the rasteriser compiles equal shaders anew
  '--enable-angle-features=preferGlobalPipelineCache',
];

/** Flags for a machine with a GPU: the same, less what is for the software rasteriser. @type {readonly string[]} */
export const gpuFlags = softwareFlags.filter((flag) => !/swiftshader|angle-features/.test(flag));

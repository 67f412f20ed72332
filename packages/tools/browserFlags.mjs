/**
 * The last list given stands: here are Playwright's own, the renderer kept in spare, and the popups of the address bar,
 * two pages that each window loads unseen at half a second of a core.
 */
const disabledFeatures = [
  'AimEnabled',
  'AvoidCorsURLLoaderRestartOnRedirect',
  'AvoidUnnecessaryBeforeUnloadCheckSync',
  'DestroyProfileOnBrowserClose',
  'HttpsFirstBalancedModeAutoEnable',
  'HttpsUpgrades',
  'LensOverlay',
  'MediaRouter',
  'NetworkTimeServiceQuerying',
  'OptimizationHints',
  'PaintHolding',
  'PreconnectToSearch',
  'SpareRendererForSitePerProcess',
  'TcpPortRandomizationWin',
  'ThirdPartyStoragePartitioning',
  'WebUIOmniboxAimPopup',
  'WebUIOmniboxPopup',
];

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
  // the page round the canvas is cheaper to put together without the rasteriser of WebGL
  '--disable-gpu-compositing',
  `--disable-features=${disabledFeatures.join(',')}`,
  // else each program has a pipeline cache of its own, and the rasteriser compiles equal shaders anew
  '--enable-angle-features=preferGlobalPipelineCache',
];

/**
 * Flags for a machine with a GPU: `softwareFlags` without those of the software rasteriser. @type {readonly string[]}
 */
export const gpuFlags = softwareFlags.filter((flag) => !/swiftshader|angle-features|gpu-compositing/.test(flag));

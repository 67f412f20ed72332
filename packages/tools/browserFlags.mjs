/**
 * Features for `--disable-features`. Chromium obeys the last such flag alone, so Playwright's own list is repeated
 * here, then the spare renderer and the address bar's popups, two hidden pages that cost 0.5 s of CPU in each window.
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
  // the page round the canvas is composited faster without the software GL
  '--disable-gpu-compositing',
  `--disable-features=${disabledFeatures.join(',')}`,
  // else each program has a pipeline cache of its own, and the rasteriser compiles equal shaders anew
  '--enable-angle-features=preferGlobalPipelineCache',
];

/**
 * Flags for a machine with a GPU: `softwareFlags` without those of the software rasteriser. @type {readonly string[]}
 */
export const gpuFlags = softwareFlags.filter((flag) => !/swiftshader|angle-features|gpu-compositing/.test(flag));

/** Browser and operating system, as people call them. */
export interface BrowserName {
  /** Name and major version: `Chrome 142`. */
  browser: string;
  /** `Windows`, `macOS`, `Linux`, `Android`, `iOS`, or what the browser says. */
  system: string;
}

/** The order matters: Edge and Opera name Chrome too, and Chrome names Safari. */
const browsers: readonly [RegExp, string][] = [
  [/Edg(?:e|A|iOS)?\/(\d+)/, 'Edge'],
  [/OPR\/(\d+)/, 'Opera'],
  [/SamsungBrowser\/(\d+)/, 'Samsung Internet'],
  [/(?:Firefox|FxiOS)\/(\d+)/, 'Firefox'],
  [/(?:HeadlessChrome|Chrome|CriOS)\/(\d+)/, 'Chrome'],
  [/Version\/(\d+)[\d.]*.* Safari\//, 'Safari'],
];
const systems: readonly [RegExp, string][] = [
  [/Android/, 'Android'],
  [/iPhone|iPad|iPod/, 'iOS'],
  [/Windows/, 'Windows'],
  [/Mac OS X|Macintosh/, 'macOS'],
  [/CrOS/, 'ChromeOS'],
  [/Linux|X11/, 'Linux'],
];

/** Reads a user agent string. What is unknown is called so. */
export function browserName(userAgent: string): BrowserName {
  const browser = browsers.find(([pattern]) => pattern.test(userAgent));
  const version = browser?.[0].exec(userAgent)?.[1];
  return {
    browser: browser ? `${browser[1]} ${version}` : 'Unknown browser',
    system: systems.find(([pattern]) => pattern.test(userAgent))?.[1] ?? 'Unknown system',
  };
}

/**
 * The graphics device without what ANGLE puts round its name: `NVIDIA GeForce RTX 3080` of
 * `ANGLE (NVIDIA, NVIDIA GeForce RTX 3080 (0x00002206) Direct3D11 vs_5_0 ps_5_0, D3D11)`.
 */
export function deviceName(renderer: string): string {
  const inside = /^ANGLE \((?:[^,]*), (.*), [^,]*\)$/.exec(renderer)?.[1] ?? renderer;
  const metal = /^ANGLE Metal Renderer: (.*)$/.exec(inside)?.[1] ?? inside;
  const vulkan = /^Vulkan [\d.]+ \((.*)\)$/.exec(metal)?.[1] ?? metal;
  return vulkan
    .replace(/ \(0x[0-9a-f]+\)/gi, '')
    .replace(/ (Direct3D\d*|OpenGL( ES)?|Vulkan [\d.]+).*$/, '')
    .replace(/\/PCIe\/SSE2$/, '')
    .trim();
}

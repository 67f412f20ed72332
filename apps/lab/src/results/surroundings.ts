import { competitorNames } from '../competitors/competitorNames';
import { installedRivals } from '../competitors/installedRivals';
import type { LabSurroundings } from './LabRun';

declare const __FAROL_BUILD__: string | undefined;
declare const __FAROL_VERSIONS__: Record<string, string> | undefined;

interface Brand {
  readonly brand: string;
  readonly version: string;
}

/** `navigator.userAgentData`, which Chromium has in secure contexts. */
interface UserAgentData {
  readonly brands: readonly Brand[];
  readonly platform: string;
  getHighEntropyValues(hints: string[]): Promise<{ fullVersionList?: readonly Brand[]; platformVersion?: string }>;
}

/** The properties of `navigator` that are read. */
export interface NavigatorInfo {
  readonly userAgent: string;
  readonly hardwareConcurrency?: number;
  readonly userAgentData?: UserAgentData;
}

const words: Readonly<Record<string, { kind: string }>> = competitorNames;

/**
 * Surroundings of a run that begins now.
 *
 * @param device - result of the stage's `device`
 * @param competitors - keys of the measured competitors; versions of other engines are queried if one is among them
 * @param info - default `navigator`
 */
export async function surroundingsOf(
  device: { readonly renderer: string; readonly software: boolean },
  competitors: readonly string[] = [],
  info: NavigatorInfo = navigator,
): Promise<LabSurroundings> {
  const { browser, system } = await browserOf(info);
  const hasRival = competitors.some((name) => words[name]?.kind === 'rival');
  const rivals = hasRival ? (await installedRivals()).versions : {};
  return {
    date: new Date().toISOString(),
    device: device.renderer || 'unknown',
    browser,
    system,
    cores: info.hardwareConcurrency || null,
    build: typeof __FAROL_BUILD__ === 'undefined' ? 'unknown' : __FAROL_BUILD__,
    versions: { ...(typeof __FAROL_VERSIONS__ === 'undefined' ? {} : __FAROL_VERSIONS__), ...rivals },
    command: null,
    warnings: device.software
      ? ['A software rasteriser draws here, on the processor: its figures say little about graphics cards.']
      : [],
  };
}

/** Name and version of the browser and of the operating system. */
async function browserOf({ userAgent, userAgentData }: NavigatorInfo): Promise<{ browser: string; system: string }> {
  if (!userAgentData) return { browser: browserIn(userAgent), system: systemIn(userAgent) };
  const { platform, brands } = userAgentData;
  const { fullVersionList = brands, platformVersion = '' } = await userAgentData
    .getHighEntropyValues(['fullVersionList', 'platformVersion'])
    .catch(() => ({}) as { fullVersionList?: readonly Brand[]; platformVersion?: string });
  // browsers add a fake brand to the list, which is skipped
  const real = fullVersionList.filter(({ brand }) => !/not.*brand/i.test(brand));
  const product = real.find(({ brand }) => brand !== 'Chromium') ?? real[0];
  return {
    browser: product ? `${product.brand} ${product.version}` : browserIn(userAgent),
    system: `${platform} ${platform === 'Windows' ? windowsVersion(platformVersion) : platformVersion}`.trim(),
  };
}

/** Version of Windows by its platform version: 13 or more for Windows 11. */
function windowsVersion(platformVersion: string): string {
  const major = Number.parseInt(platformVersion, 10);
  return major >= 13 ? '11' : major >= 1 ? '10' : platformVersion;
}

/** Patterns in order of priority: strings of Edge and Opera contain Chrome's name, Chrome's contains Safari's. */
const browsers: readonly [string, RegExp][] = [
  ['Edge', /Edg\w*\/([\d.]+)/],
  ['Opera', /OPR\/([\d.]+)/],
  ['Firefox', /(?:Firefox|FxiOS)\/([\d.]+)/],
  ['Chrome', /(?:Chrome|CriOS)\/([\d.]+)/],
  ['Safari', /Version\/([\d.]+).*Safari\//],
];

function browserIn(userAgent: string): string {
  for (const [name, pattern] of browsers) {
    const version = pattern.exec(userAgent)?.[1];
    if (version) return `${name} ${version}`;
  }
  return userAgent || 'unknown';
}

const systems: readonly [string, RegExp][] = [
  ['Android', /Android ?([\d.]*)/],
  ['iOS', /(?:iPhone|iPad).* OS ([\d_]+)/],
  ['Windows', /Windows NT ([\d.]+)/],
  ['macOS', /Mac OS X ([\d_.]*)/],
  ['ChromeOS', /CrOS \w+ ([\d.]*)/],
  ['Linux', /Linux()/],
];

function systemIn(userAgent: string): string {
  for (const [name, pattern] of systems) {
    const found = pattern.exec(userAgent);
    if (found) return `${name} ${found[1].replaceAll('_', '.')}`.trim();
  }
  return 'unknown';
}
